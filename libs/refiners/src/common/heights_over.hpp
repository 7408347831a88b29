// SPDX-License-Identifier: Apache-2.0
// Heights over the ground along a straight leg; private.
#pragma once

#include "skein/world/terrain.hpp"

namespace skein::refiners {

struct HeightRange {
  double least = 0, greatest = 0;  ///< [m] over the ground
};

/// Exact on the bilinear ground, including its continuation outside the extent.
/// Cost: O(k log k), where k is the number of grid lines crossed.
HeightRange heights_over(const world::Terrain& terrain, const world::Vector3& from,
                         const world::Vector3& to);

}  // namespace skein::refiners
