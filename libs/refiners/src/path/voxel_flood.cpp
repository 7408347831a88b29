// SPDX-License-Identifier: Apache-2.0
#include "path/voxel_flood.hpp"

#include <vector>

#include "path/facet_graph.hpp"
#include "path/free_voxels.hpp"

namespace skein::refiners {

std::optional<bool> connected(const world::Airspace& airspace, const world::Voxel& from,
                              const world::Voxel& to, std::size_t most, const Budget& budget) {
  const auto index = [&](const world::Voxel& at) {
    return airspace.grid().index(at[0], at[1], at[2]);
  };
  const FreeVoxels is_free(airspace);
  std::vector<bool> reached(airspace.voxels().size());
  std::vector<world::Voxel> front = {from}, next;
  reached[index(from)] = true;
  for (std::size_t count = 0; !front.empty(); front.swap(next), next.clear())
    for (const world::Voxel& voxel : front) {
      if (voxel == to) return true;
      if (++count > most || (count % 4096 == 0 && budget.expired())) return std::nullopt;
      for (Facet facet = 0; facet < 6; ++facet) {
        const world::Voxel other = beyond(voxel, facet);
        if (!is_free(other) || reached[index(other)]) continue;
        reached[index(other)] = true;
        next.push_back(other);
      }
    }
  return false;
}

}  // namespace skein::refiners
