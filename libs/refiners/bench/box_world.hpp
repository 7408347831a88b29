// SPDX-License-Identifier: Apache-2.0
// The world and the queries of the benches of path, and how they count.
//
// World: 256³ voxels, boxes with sides uniform in [8, 32] put at random until 49 % is occupied. 20
// queries between random free voxels at least 150 voxels apart that a way connects. Seeds are
// fixed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners::bench {

using world::Airspace;
using world::Voxel;

inline constexpr std::int32_t kSide = 256;

inline Airspace box_world(std::uint64_t seed = 1) {
  world::AirspaceGrid grid;
  grid.voxel = 1;
  grid.size = {kSide, kSide, kSide};
  std::vector<std::uint8_t> voxels(grid.count(), Airspace::kPlain);
  Random random(seed);
  std::size_t occupied = 0;
  while (static_cast<double>(occupied) < 0.49 * static_cast<double>(grid.count())) {
    Voxel low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto side = static_cast<std::int32_t>(8 + random.below(25));
      low[i] = static_cast<std::int32_t>(random.below(kSide + 16)) - 16;
      high[i] = std::min(low[i] + side, kSide);
      low[i] = std::max(low[i], 0);
    }
    for (std::int32_t z = low[2]; z < high[2]; ++z)
      for (std::int32_t y = low[1]; y < high[1]; ++y)
        for (std::int32_t x = low[0]; x < high[0]; ++x) {
          std::uint8_t& voxel = voxels[grid.index(x, y, z)];
          occupied += voxel != Airspace::kBlocked ? 1 : 0;
          voxel = Airspace::kBlocked;
        }
  }
  return {grid, std::move(voxels)};
}

inline double percent_occupied(const Airspace& airspace) {
  const auto& voxels = airspace.voxels();
  return 100 * static_cast<double>(std::count(voxels.begin(), voxels.end(), Airspace::kBlocked)) /
         static_cast<double>(voxels.size());
}

struct Ends {
  Voxel from, to;
};

inline Voxel free_voxel(const Airspace& airspace, Random& random) {
  Voxel voxel{};
  do {
    for (std::int32_t& along : voxel) along = static_cast<std::int32_t>(random.below(kSide));
  } while (!airspace.is_free(voxel));
  return voxel;
}

inline std::vector<Ends> long_queries(const Airspace& airspace, std::size_t count = 20) {
  Random random(7, "queries");
  std::vector<Ends> queries;
  while (queries.size() < count) {
    const Ends ends{free_voxel(airspace, random), free_voxel(airspace, random)};
    if ((airspace.centre(ends.to) - airspace.centre(ends.from)).norm() < 150) continue;
    if (search_graph(airspace, ends.from, ends.to, Budget()).found) queries.push_back(ends);
  }
  return queries;
}

inline double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}
inline double total(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

}  // namespace skein::refiners::bench
