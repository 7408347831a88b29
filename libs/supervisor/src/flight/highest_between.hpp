// SPDX-License-Identifier: Apache-2.0
// The ground between two places.
#pragma once

#include "skein/world/terrain.hpp"

namespace skein::supervisor {

/// The highest elevation on the straight line between two places, apart from below these, of one
/// each `step` [m] or so; minus infinity where they are nearer. Cost: O(places looked at).
double highest_between(const world::Terrain& terrain, const world::Vector3& from,
                       const world::Vector3& to, double step);

}  // namespace skein::supervisor
