// SPDX-License-Identifier: Apache-2.0
// Distances to closed air, and volumes of it grown by a margin.
#pragma once

#include <vector>

#include "skein/world/volume.hpp"

namespace skein::supervisor {

/// Whether `at` is in the volume, or nearer to it than `margin` [m], horizontally and vertically.
bool is_near(const world::Volume& volume, const world::Vector3& at, double margin);

/// The convex hull of the volume grown by `margin` [m]; a corner reaches at most 4 % further. Cost:
/// O(corners log corners).
world::Volume grown(const world::Volume& volume, double margin);

}  // namespace skein::supervisor
