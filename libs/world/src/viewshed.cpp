// SPDX-License-Identifier: Apache-2.0
#include "skein/world/viewshed.hpp"

namespace skein::world {

std::vector<bool> viewshed(const Terrain& terrain, const Grid& grid, const ViewshedQuery& query) {
  std::vector<bool> seen(grid.size());
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const Vector2 centre = grid.centre(cell);
    const Vector3 point(centre.x(), centre.y(),
                        terrain.elevation(centre.x(), centre.y()) + query.height);
    seen[cell] = (point - query.viewpoint).norm() <= query.range &&
                 terrain.line_of_sight(query.viewpoint, point);
  }
  return seen;
}

}  // namespace skein::world
