// SPDX-License-Identifier: Apache-2.0
#include "path/approach.hpp"

#include <algorithm>

#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using world::Airspace;
using world::Vector3;
using world::Voxel;

constexpr std::int32_t kFiner = 8;       // voxels of the fine grid along one of the coarse
constexpr std::int32_t kReach = 20;      // voxels of the fine grid on each side of the place
constexpr std::size_t kMostTried = 200;  // free voxels around

/// A grid around a place, which is at the centre of its middle voxel.
world::AirspaceGrid grid_around(const Vector3& place, double voxel) {
  world::AirspaceGrid grid;
  grid.voxel = voxel;
  grid.size = {2 * kReach + 1, 2 * kReach + 1, 2 * kReach + 1};
  grid.origin = place - Vector3::Constant((kReach + 0.5) * voxel);
  return grid;
}

/// The free voxels whose centres are in reach of the fine grid, those on the way first.
std::vector<Voxel> free_around(const Airspace& airspace, const Voxel& middle, const Vector3& place,
                               const Vector3& toward) {
  constexpr std::int32_t kRange = kReach / kFiner;
  std::vector<std::pair<double, Voxel>> found;
  for (std::int32_t z = -kRange; z <= kRange; ++z)
    for (std::int32_t y = -kRange; y <= kRange; ++y)
      for (std::int32_t x = -kRange; x <= kRange; ++x) {
        const Voxel voxel{middle[0] + x, middle[1] + y, middle[2] + z};
        if (!airspace.is_free(voxel)) continue;
        const Vector3 centre = airspace.centre(voxel);
        found.emplace_back((centre - place).norm() + (toward - centre).norm(), voxel);
      }
  std::sort(found.begin(), found.end());
  std::vector<Voxel> voxels;
  for (std::size_t i = 0; i < std::min(found.size(), kMostTried); ++i)
    voxels.push_back(found[i].second);
  return voxels;
}

/// Through the fine voxels, round what is in between.
std::optional<Way> wind_through(const Airspace& near, const Vector3& place, const Vector3& centre,
                                const Budget& budget) {
  if (!near.is_free(centre)) return std::nullopt;
  VoxelWay found = find_way(near, place, centre, {budget.time_is_up});
  if (!found.found) return std::nullopt;
  return std::move(found.way);
}

}  // namespace

std::optional<Approach> approach(const PathSpace& space, const Airspace& airspace,
                                 const Vector3& place, const Vector3& toward,
                                 const Budget& budget) {
  if (const auto voxel = airspace.free_voxel_at(place)) return Approach{*voxel, {place}, {}};
  const auto middle = airspace.voxel_at(place);
  if (!middle) return std::nullopt;
  const world::AirspaceGrid grid = grid_around(place, airspace.grid().voxel / kFiner);
  Approach found{{}, {}, space.airspace(grid, budget)};
  if (!found.near || !found.near->is_free(place)) return std::nullopt;
  const std::vector<Voxel> around = free_around(airspace, *middle, place, toward);
  for (const Voxel& voxel : around)
    if (found.near->is_free(place, airspace.centre(voxel))) {
      found.voxel = voxel;
      found.way = {place, airspace.centre(voxel)};
      return found;
    }
  constexpr std::size_t kMostWound = 8;
  for (std::size_t i = 0; i < std::min(around.size(), kMostWound); ++i)
    if (auto way = wind_through(*found.near, place, airspace.centre(around[i]), budget)) {
      found.voxel = around[i];
      found.way = std::move(*way);
      return found;
    }
  return std::nullopt;
}

}  // namespace skein::refiners
