// SPDX-License-Identifier: Apache-2.0
// Visibility of ground cells from a viewpoint.
#pragma once

#include <limits>
#include <vector>

#include "skein/world/grid.hpp"
#include "skein/world/terrain.hpp"

namespace skein::world {

struct ViewshedQuery {
  Vector3 viewpoint = Vector3::Zero();                     ///< [m], ENU
  double range = std::numeric_limits<double>::infinity();  ///< range of sight, in space [m]
  double height = 0.01;  ///< of the point to be seen, above the ground at the centre of a cell [m]
};

/// Whether the point at query.height above this place is seen: within range and in line of sight.
bool is_seen(const Terrain& terrain, const Vector2& place, const ViewshedQuery& query);

/// For each cell of the grid, whether a point at its centre is seen: within range and in line of
/// sight, by Terrain::line_of_sight, so exact for the bilinear ground. No curvature of the Earth,
/// no refraction. Cells outside the terrain are seen unless the terrain hides them. Cost: O(cells ×
/// cells along a line of sight), about 0.5 s for 400 × 350.
std::vector<bool> viewshed(const Terrain& terrain, const Grid& grid, const ViewshedQuery& query);

}  // namespace skein::world
