// SPDX-License-Identifier: Apache-2.0
// Ways over a valley: random trees against voxels, in the same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>

#include "skein/refiners/voxel_path_planner.hpp"
#include "skein/sampling/collision_scene.hpp"
#include "skein/sampling/sampling_path_planner.hpp"

namespace skein::sampling {
namespace {

using world::Vector3;

/// Two ridges with a pass each, 2.5 km by 2.5 km, cells of 20 m, voxels of 20 m.
world::World valley() {
  world::TerrainSpec terrain;
  terrain.east = terrain.north = 2500;
  for (int i = 0; i < 12; ++i) {
    if (i != 3) terrain.hills.push_back({{900, 100.0 + 210 * i}, 260, 300});
    if (i != 9) terrain.hills.push_back({{1700, 100.0 + 210 * i}, 260, 300});
  }
  world::World world{{}, world::Terrain(terrain), {}, {}, {}, {}, {}, {}, {}};
  world.airspace = {{0, 0, 0}, 20, {125, 125, 20}};
  world.volumes = {{"village",
                    {{1150, 900}, {1450, 900}, {1450, 1800}, {1300, 1200}, {1150, 1800}},
                    -10,
                    300,
                    {}}};
  return world;
}

refiners::PathQuery query_of(int i) {
  refiners::PathQuery query;
  query.vehicle.cruise_speed = 8;
  query.vehicle.max_speed = 12;
  query.vehicle.climb_rate = 2.5;
  query.vehicle.descent_rate = 1.5;
  query.vehicle.acceleration = 1.5;
  query.vehicle.yaw_rate = 0.6;
  query.vehicle.ceiling = 150;
  query.vehicle.energy.capacity = 7e6;
  query.vehicle.energy.hover_power = 1900;
  query.vehicle.energy.cruise_power = 1700;
  query.clearance = 15;
  query.from = {150, 250.0 + 220 * i, 70};
  query.to = {2350, 2250.0 - 220 * i, 70};
  return query;
}

void run(benchmark::State& state, const refiners::PathPlanner& planner) {
  const world::World world = valley();
  double length = 0;
  int found = 0, asked = 0;
  for (auto _ : state) {
    const auto path =
        planner.plan(query_of(asked++ % 10), refiners::Setting{.world = world, .budget = {}});
    if (!path) continue;
    ++found;
    length += path->task.length;
  }
  state.counters["mean_length_m"] = found ? length / found : 0;
  state.counters["found"] = static_cast<double>(found) / asked;
}

void voxels(benchmark::State& state) { run(state, refiners::VoxelPathPlanner()); }
void trees(benchmark::State& state) { run(state, SamplingPathPlanner()); }
void trees_first_way(benchmark::State& state) {
  run(state, SamplingPathPlanner({.shortening_samples = 0}));
}
void scene(benchmark::State& state) {
  const world::World world = valley();
  for (auto _ : state) benchmark::DoNotOptimize(CollisionScene(world, {.clearance = 15}));
}

BENCHMARK(voxels)->Iterations(10)->Unit(benchmark::kMillisecond);
BENCHMARK(trees)->Iterations(10)->Unit(benchmark::kMillisecond);
BENCHMARK(trees_first_way)->Iterations(10)->Unit(benchmark::kMillisecond);
BENCHMARK(scene)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skein::sampling

BENCHMARK_MAIN();
