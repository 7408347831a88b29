// SPDX-License-Identifier: Apache-2.0
#include "common/heights_over.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/ground_profile.hpp"

namespace skein::refiners {
HeightRange heights_over(const world::Terrain& terrain, const world::Vector3& from,
                         const world::Vector3& to) {
  const std::vector<double> fractions = grid_crossings(terrain, from.head<2>(), to.head<2>());

  const auto height = [&](double fraction) {
    const world::Vector3 at = from + fraction * (to - from);
    return at.z() - terrain.elevation(at.x(), at.y());
  };
  HeightRange range{height(0), height(0)};
  const auto include = [&](double value) {
    range = {std::min(range.least, value), std::max(range.greatest, value)};
  };
  for (std::size_t i = 1; i < fractions.size(); ++i) {
    // Between two grid lines the height is a quadratic: h0 + b t + a t², with t from 0 to 1.
    const double begin = fractions[i - 1], size = fractions[i] - begin;
    const double h0 = height(begin), h1 = height(begin + size), middle = height(begin + size / 2);
    include(h1);
    const double a = 2 * (h0 + h1 - 2 * middle), b = h1 - h0 - a;
    const double turning = a != 0 ? -b / (2 * a) : 0;
    if (turning > 0 && turning < 1) include(h0 + (b + a * turning) * turning);
  }
  return range;
}

}  // namespace skein::refiners
