// SPDX-License-Identifier: Apache-2.0
// Which cells of the ground are seen from a place.
#pragma once

#include <limits>
#include <vector>

#include "skein/world/grid.hpp"
#include "skein/world/terrain.hpp"

namespace skein::world {

struct ViewshedQuery {
  Vector3 viewpoint = Vector3::Zero();                     ///< [m], ENU
  double range = std::numeric_limits<double>::infinity();  ///< of sight, in space [m]
  double height = 0.01;  ///< over the ground at the centre of a cell, of what is to be seen [m]
};

/// Whether a point over that place of the ground is seen: within range and in line of sight.
bool is_seen(const Terrain& terrain, const Vector2& place, const ViewshedQuery& query);

/// For each cell of the grid, whether a point at its centre is seen: within range and in line of
/// sight, by Terrain::line_of_sight, so exact for the bilinear ground. No curvature of the Earth,
/// no refraction. Cells outside the terrain are seen where nothing of it stands in between. Cost:
/// O(cells × cells on the way), about 0.5 s for 400 × 350.
std::vector<bool> viewshed(const Terrain& terrain, const Grid& grid, const ViewshedQuery& query);

}  // namespace skein::world
