// SPDX-License-Identifier: Apache-2.0
#include "page_grid.hpp"

#include <algorithm>
#include <cmath>

namespace skein::ground_setup {

world::Grid page_grid(const world::TerrainSpec& spec) {
  constexpr int kMostPoints = 160;  // along each side
  const double width = spec.east - spec.west, height = spec.north - spec.south;
  const double step =
      std::max({spec.cell, width / (kMostPoints - 1), height / (kMostPoints - 1), 1.0});
  return {spec.west - step / 2, spec.south - step / 2, step,
          static_cast<std::size_t>(std::floor(width / step)) + 1,
          static_cast<std::size_t>(std::floor(height / step)) + 1};
}

}  // namespace skein::ground_setup
