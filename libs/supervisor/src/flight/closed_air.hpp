// SPDX-License-Identifier: Apache-2.0
// Closed air and how near to it one is: volumes grown by what a vehicle strays.
#pragma once

#include <vector>

#include "skein/world/volume.hpp"

namespace skein::supervisor {

/// In the volume, or nearer to it than `margin`, horizontally and vertically.
bool is_near(const world::Volume& volume, const world::Vector3& at, double margin);

/// The volume and all that is nearer to it than `margin` [m], and the hull of that: a corner
/// reaches at most 4 % further. Cost: O(corners log corners).
world::Volume grown(const world::Volume& volume, double margin);

}  // namespace skein::supervisor
