// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/driving.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/plain_way.hpp"
#include "common/shared_checks.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/refiners/checks.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {

namespace {

using world::Airspace;
using world::AirspaceGrid;
using world::Terrain;
using world::Vector3;
using world::VehicleModel;
using world::Voxel;

constexpr double kFinest = 5;           // [m] side of a voxel, about
constexpr std::size_t kMost = 1000000;  // voxels
constexpr double kInset = 1e-3;  // of a voxel: so far from its sides its corners are looked at
constexpr double kTall = 2;      // [m] a volume that begins higher over the ground lets it pass
constexpr double kJoined = 60;   // [m] from a place to the map, at most
constexpr std::size_t kDirections = 24, kMostJoined = 6;

/// Whole voxels to a cell of the terrain: the slope of a cell is greatest at its corners.
AirspaceGrid layer_over(const Terrain& terrain) {
  const world::TerrainSpec& spec = terrain.spec();
  const auto with = [&](double voxel) {
    AirspaceGrid grid;
    grid.voxel = voxel;
    grid.origin = Vector3(spec.west, spec.south, -voxel / 2);
    grid.size = {std::max(1, static_cast<int>(std::ceil((spec.east - spec.west) / voxel - 1e-9))),
                 std::max(1, static_cast<int>(std::ceil((spec.north - spec.south) / voxel - 1e-9))),
                 1};
    return grid;
  };
  for (int parts = std::max(1, static_cast<int>(std::ceil(spec.cell / kFinest))); parts > 1;
       --parts) {
    const AirspaceGrid grid = with(spec.cell / parts);
    if (grid.count() <= kMost) return grid;
  }
  return with(spec.cell);
}

bool is_steep(const Terrain& terrain, const Vector3& centre, double half, double steepest) {
  const double off = half * (1 - kInset);
  for (const double x : {-off, 0.0, off})
    for (const double y : {-off, 0.0, off})
      if (terrain.slope(centre.x() + x, centre.y() + y) > steepest) return true;
  return false;
}

/// True of all that are near one that is.
std::vector<bool> widened(const std::vector<bool>& closed, const AirspaceGrid& grid) {
  std::vector<bool> result(closed.size(), false);
  const auto columns = grid.size[0], rows = grid.size[1];
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (!closed[grid.index(column, row, 0)]) continue;
      for (int y = std::max(0, row - 1); y <= std::min(rows - 1, row + 1); ++y)
        for (int x = std::max(0, column - 1); x <= std::min(columns - 1, column + 1); ++x)
          result[grid.index(x, y, 0)] = true;
    }
  }
  return result;
}

void block_steep(Airspace& map, const Terrain& terrain, double steepest) {
  const AirspaceGrid& grid = map.grid();
  std::vector<bool> steep(grid.count(), false);
  map.keep_where([&](const Voxel& at) {
    steep[grid.index(at[0], at[1], at[2])] =
        is_steep(terrain, map.centre(at), grid.voxel / 2, steepest);
    return true;
  });
  const std::vector<bool> closed = widened(steep, grid);
  map.keep_where([&](const Voxel& at) { return !closed[grid.index(at[0], at[1], at[2])]; });
}

/// Where it reaches down to the ground.
void block_volume(Airspace& map, const Terrain& terrain, const world::Volume& volume,
                  double margin) {
  world::Volume flat = volume;
  flat.floor = -1;
  flat.ceiling = 1;
  Airspace touched(map.grid());
  touched.block(flat, margin);
  map.keep_where([&](const Voxel& at) {
    const Vector3 centre = map.centre(at);
    const double ground = terrain.elevation(centre.x(), centre.y());
    return touched.is_free(at) || volume.floor > ground + kTall || volume.ceiling < ground;
  });
}

bool is_steep_between(const Terrain& terrain, const Vector3& from, const Vector3& to,
                      double steepest) {
  const double step = std::min(kFinest, terrain.spec().cell / 4);
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
  for (int i = 0; i <= pieces; ++i) {
    const Vector3 at = from + (to - from) * (static_cast<double>(i) / pieces);
    if (terrain.slope(at.x(), at.y()) > steepest) return true;
  }
  return false;
}

/// The place itself, or those on the map that it can drive straight to, the nearest first and one
/// in each direction: some may be shut off, as the top of a hill is.
std::vector<Vector3> joined(const Airspace& map, const Terrain& terrain, const Vector3& at,
                            double steepest) {
  if (map.is_free(at)) return {at};
  std::vector<Vector3> all;
  std::vector<bool> taken(kDirections, false);
  for (double far = map.grid().voxel / 2; far <= kJoined; far += map.grid().voxel / 2) {
    for (std::size_t i = 0; i < taken.size() && all.size() < kMostJoined; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kDirections;
      const Vector3 to = at + far * Vector3(std::cos(angle), std::sin(angle), 0);
      if (taken[i] || !map.is_free(to) || is_steep_between(terrain, at, to, steepest)) continue;
      taken[i] = true;
      all.push_back(to);
    }
  }
  return all;
}

/// From one of them to one of the others; the first that is found.
VoxelWay find_any(const Airspace& map, const std::vector<Vector3>& begins,
                  const std::vector<Vector3>& ends, const Budget& budget) {
  VoxelWay found;
  for (const Vector3& begin : begins) {
    for (const Vector3& end : ends) {
      found = find_way(map, begin, end, budget, WaySearch::kQuick);
      if (found.found || found.out_of_budget) return found;
    }
  }
  return found;
}

/// Of one that stands on ground that is too steep the slope there counts for nothing.
std::optional<Refusal> problem_of(const Terrain& terrain, const Vector3& at, double steepest,
                                  const std::string& field) {
  if (!terrain.contains(at.x(), at.y()))
    return Refusal{RefusalKind::kBlocked, field, "it is outside the terrain"};
  const double slope = terrain.slope(at.x(), at.y());
  if (slope <= steepest) return std::nullopt;
  const auto degrees = [](double angle) { return rounded(angle * 180 / std::numbers::pi); };
  return Refusal{RefusalKind::kBlocked, field,
                 "the ground there slopes by " + degrees(slope) + " degrees, and it climbs " +
                     degrees(steepest)};
}

}  // namespace

Airspace drivable_ground(const Terrain& terrain, const VehicleModel& vehicle,
                         const std::vector<world::Volume>& volumes, double margin) {
  SKEIN_EXPECTS(vehicle.ground.has_value());
  Airspace map(layer_over(terrain));
  block_steep(map, terrain, vehicle.ground->steepest);
  for (const world::Volume& volume : volumes) block_volume(map, terrain, volume, margin);
  return map;
}

Vector3 on_ground(const Terrain& terrain, const Vector3& at) {
  return {at.x(), at.y(), terrain.elevation(at.x(), at.y())};
}

Way draped(const Way& way, const Terrain& terrain) {
  Way result;
  const double step = terrain.spec().cell / 2;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vector3 from = i == 0 ? way[i] : way[i - 1];
    const double length = (way[i] - from).head<2>().norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 1; k <= pieces; ++k)
      result.push_back(
          on_ground(terrain, from + (way[i] - from) * (static_cast<double>(k) / pieces)));
  }
  return result;
}

Outcome<Path> DrivingPlanner::plan(const PathQuery& query, const Setting& setting) const {
  const Terrain& terrain = setting.world.terrain;
  if (!query.vehicle.ground)
    return refuse(RefusalKind::kBadQuery, "vehicle", "the vehicle does not keep to the ground");
  const double steepest = query.vehicle.ground->steepest;
  const Vector3 from = on_map(query.from), to = on_map(query.to);
  if (auto problem = problem_of(terrain, to, steepest, "to"))
    return tl::unexpected(std::move(*problem));
  const bool stuck = terrain.slope(from.x(), from.y()) > steepest;
  const double off = stuck ? std::numbers::pi : steepest;
  const auto begins = joined(map_, terrain, from, off), ends = joined(map_, terrain, to, steepest);
  if (begins.empty() || ends.empty())
    return refuse(RefusalKind::kBlocked, ends.empty() ? "to" : "from",
                  "no ground near it can be driven on");
  const VoxelWay found = find_any(map_, begins, ends, setting.budget);
  if (found.out_of_budget)
    return refuse(RefusalKind::kBudgetExhausted, "", "the budget was used up during the search");
  if (!found.found)
    return refuse(RefusalKind::kUnreachable, "to", "no way over ground that it can drive on");
  Way way = {from};
  way.insert(way.end(), found.way.begin(), found.way.end());
  way.push_back(to);
  Path path;
  for (Vector3& at : way) at = on_ground(terrain, at);
  path.way = without_repeats(std::move(way));
  const Flight drive =
      estimate_flight(draped(path.way, terrain), query.vehicle, setting.world.wind, query.speed);
  path.length = drive.length;
  path.energy = drive.energy;
  return Refined<Path>{std::move(path), found.cost, drive.duration, found.effort};
}

}  // namespace skein::refiners
