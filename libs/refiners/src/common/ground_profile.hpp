// SPDX-License-Identifier: Apache-2.0
// An upper profile of the ground below a straight leg, with few points.
#pragma once

#include <vector>

#include "skein/world/terrain.hpp"

namespace skein::refiners {

struct GroundPoint {
  double part = 0;    ///< of the leg, [0, 1]
  double ground = 0;  ///< ENU z [m]
};

/// Whether the whole terrain has one height.
bool is_level(const world::Terrain& terrain);

/// Fractions of a leg at which it crosses the lines of the grid of elevations, 0 and 1 among them,
/// ascending.
std::vector<double> grid_crossings(const world::Terrain& terrain, const world::Vector2& from,
                                   const world::Vector2& to);

/// From 0 to 1, ascending: where the leg crosses the lines of the grid, and up to three points in
/// between. The ground is never above the straight lines between these points (it is a quadratic
/// between two grid lines), and as high as they are at the lines of the grid. Level ground: the
/// ends alone. Cost: O(cells crossed).
std::vector<GroundPoint> ground_along(const world::Terrain& terrain, const world::Vector2& from,
                                      const world::Vector2& to);

}  // namespace skein::refiners
