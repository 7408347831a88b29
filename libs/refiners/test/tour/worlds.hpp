// SPDX-License-Identifier: Apache-2.0
// Tours among hills, where most straight lines between stops are closed. For tests and benches.
#pragma once

#include <algorithm>

#include "skein/foundation/random.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "testing/builders.hpp"

namespace skein::refiners::test {

/// The valley of scenarios/terrain/valley.yaml: two kilometres, hills of up to 220 m, voxels of
/// 10 m up to 340 m, a village not to be flown over low, wind.
inline world::World hills() {
  world::World world = testing::level_world();
  world::TerrainSpec ground;
  ground.west = ground.south = -1000;
  ground.east = ground.north = 1000;
  ground.cell = 20;
  ground.hills = {{{-650, 450}, 180, 520}, {{-350, 750}, 140, 420}, {{600, 600}, 220, 600},
                  {{250, 50}, 60, 220},    {{750, -350}, 110, 380}, {{-700, -700}, 150, 450},
                  {{-100, -450}, 45, 260}};
  world.terrain = world::Terrain(ground);
  world.airspace = {.origin = {-1000, -1000, 0}, .voxel = 10, .size = {200, 200, 34}};
  world.wind = {.toward = 0.6, .speed = 3, .gusts = 0.5};
  world::Volume village;
  village.name = "village";
  village.polygon = {{-480, -160}, {-260, -200}, {-220, 20}, {-420, 60}};
  village.ceiling = 150;
  world.volumes.push_back(village);
  return world;
}

/// Stops 40 m over the ground, where a voxel is free; from and to the valley's bottom.
inline TourQuery tour_among_hills(const world::World& world, std::size_t stops, std::uint64_t seed,
                                  bool hovers = true) {
  TourQuery query;
  query.vehicle = hovers ? testing::helicopter() : testing::fixed_wing();
  query.vehicle.wind_drift = 0.5;
  query.vehicle.energy.capacity = 1e9;
  query.clearance = 15;
  query.start = {0, -800, 60};
  query.end = query.start;
  PathQuery leg;
  leg.vehicle = query.vehicle;
  leg.clearance = query.clearance;
  leg.from = leg.to = query.start;
  const auto airspace = airspace_of(leg, {world, {}});
  Random random(seed, "hills");
  while (query.stops.size() < stops) {
    world::Vector3 place(random.uniform(-950, 950), random.uniform(-950, 950), 0);
    place.z() = world.terrain.elevation(place.x(), place.y()) + 40;
    if (airspace->is_free(place)) query.stops.push_back({"", {{place, place, {}}}});
  }
  return query;
}

inline PathQuery first_leg(const TourQuery& query) {
  PathQuery leg;
  leg.vehicle = query.vehicle;
  leg.clearance = query.clearance;
  leg.speed = query.speed;
  leg.from = query.start;
  leg.to = query.stops.front().gates.front().entry;
  return leg;
}

/// Over the voxels of that airspace; counts.
class CountingPlanner final : public PathPlanner {
 public:
  explicit CountingPlanner(const world::Airspace& airspace) : on_voxels_(airspace) {}
  Outcome<Path> plan(const PathQuery& query, const Setting& setting) const override {
    ++asked_;
    return on_voxels_.plan(query, setting);
  }
  int asked() const { return asked_; }

 private:
  VoxelPathPlanner on_voxels_;
  mutable int asked_ = 0;
};

struct Closed {
  std::size_t closed = 0, pairs = 0;
};

/// Of the pairs of stops, those whose straight line is not free.
inline Closed closed_pairs(const world::Airspace& airspace, const TourQuery& query) {
  Closed count;
  for (std::size_t i = 0; i < query.stops.size(); ++i)
    for (std::size_t j = 0; j < i; ++j, ++count.pairs)
      if (!airspace.is_free(query.stops[i].gates[0].exit, query.stops[j].gates[0].entry))
        ++count.closed;
  return count;
}

}  // namespace skein::refiners::test
