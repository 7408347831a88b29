// SPDX-License-Identifier: Apache-2.0
#include "skein/world/viewshed.hpp"

namespace skein::world {

bool is_seen(const Terrain& terrain, const Vector2& place, const ViewshedQuery& query) {
  const Vector3 point(place.x(), place.y(), terrain.elevation(place.x(), place.y()) + query.height);
  return (point - query.viewpoint).norm() <= query.range &&
         terrain.line_of_sight(query.viewpoint, point);
}

std::vector<bool> viewshed(const Terrain& terrain, const Grid& grid, const ViewshedQuery& query) {
  std::vector<bool> seen(grid.size());
  for (std::size_t cell = 0; cell < grid.size(); ++cell)
    seen[cell] = is_seen(terrain, grid.centre(cell), query);
  return seen;
}

}  // namespace skein::world
