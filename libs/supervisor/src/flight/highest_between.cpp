// SPDX-License-Identifier: Apache-2.0
#include "flight/highest_between.hpp"

#include <algorithm>
#include <limits>

namespace skein::supervisor {

double highest_between(const world::Terrain& terrain, const world::Vector3& from,
                       const world::Vector3& to, double step) {
  const int pieces = std::max(1, static_cast<int>((to - from).head<2>().norm() / step));
  double highest = -std::numeric_limits<double>::infinity();
  for (int i = 1; i < pieces; ++i) {
    const world::Vector3 at = from + (to - from) * (static_cast<double>(i) / pieces);
    highest = std::max(highest, terrain.elevation(at.x(), at.y()));
  }
  return highest;
}

}  // namespace skein::supervisor
