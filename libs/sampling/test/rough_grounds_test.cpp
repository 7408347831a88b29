// SPDX-License-Identifier: Apache-2.0
// Ways of planes and blimps over six kinds of rough ground, against those of the sampling
// planner.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "skein/refiners/flyable.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "skein/sampling/sampling_path_planner.hpp"
#include "test_cases.hpp"
#include "worlds.hpp"

namespace skein::sampling {
namespace {

using world::Vector3;

constexpr double kWholeTurn = 2 * std::numbers::pi;
constexpr double kHalfGround = 1440, kBetweenPosts = 30, kGroundVoxel = 20;

using Height = std::function<double(double x, double y)>;

world::World world_over(const Height& height) {
  world::TerrainSpec spec;
  spec.west = spec.south = -kHalfGround;
  spec.east = spec.north = kHalfGround;
  spec.cell = kBetweenPosts;
  const auto corners = world::corners_of(spec);
  for (std::size_t row = 0; row < corners.rows; ++row)
    for (std::size_t column = 0; column < corners.columns; ++column)
      spec.elevations.push_back(height(static_cast<double>(column) * kBetweenPosts - kHalfGround,
                                       static_cast<double>(row) * kBetweenPosts - kHalfGround));
  world::World world = a_plain();
  world.terrain = world::Terrain(spec);
  const double low = world.terrain.lowest(), high = world.terrain.highest() + 300;
  const auto wide = static_cast<std::int32_t>(2 * kHalfGround / kGroundVoxel);
  world.airspace = {{-kHalfGround, -kHalfGround, low},
                    kGroundVoxel,
                    {wide, wide, static_cast<std::int32_t>((high - low) / kGroundVoxel)}};
  return world;
}

/// Slopes that rise gently and fall steeply, four times as long as steep.
Height saw_teeth(Random& random) {
  const double across = random.uniform(0, kWholeTurn), length = random.uniform(300, 700);
  const double height = random.uniform(216, 468);
  return [=](double x, double y) {
    const double along = x * std::cos(across) + y * std::sin(across) + 80 * std::sin((x - y) / 300);
    const double part = along / length - std::floor(along / length);
    return height * (part < 0.8 ? part / 0.8 : (1 - part) / 0.2);
  };
}

/// Winding valleys with steep sides in a high plain.
Height canyons(Random& random) {
  const double phase = random.uniform(0, kWholeTurn), course = random.uniform(0, kWholeTurn);
  const double deep = random.uniform(250, 450), width = random.uniform(120, 260);
  const double apart = random.uniform(500, 900);
  return [=](double x, double y) {
    const double along = y * std::cos(course) - x * std::sin(course);
    const double across = x * std::cos(course) + y * std::sin(course) +
                          150 * std::sin(along / 260 + phase) + 50 * std::sin(along / 90);
    const double part = across / apart - std::floor(across / apart);
    const double side = std::abs(part - 0.5) * apart - width / 2;
    return (deep + 40 * std::sin(x / 310) + 40 * std::sin(y / 270)) *
           std::clamp(side / 60, 0.0, 1.0);
  };
}

/// Level steps with short slopes between them.
Height terraces(Random& random) {
  const double phase = random.uniform(0, kWholeTurn), other = random.uniform(0, kWholeTurn);
  const double step = random.uniform(60, 120);
  return [=](double x, double y) {
    const double z = 250 + 180 * std::sin(x / 400 + phase) + 180 * std::sin(y / 430 + other) +
                     60 * std::sin((x + y) / 200);
    const double part = z / step - std::floor(z / step);
    return step * (std::floor(z / step) + std::clamp((part - 0.7) / 0.3, 0.0, 1.0));
  };
}

Height crater(Random& random) {
  const double east = random.uniform(-300, 300), north = random.uniform(-300, 300);
  const double radius = random.uniform(500, 800), height = random.uniform(250, 450);
  return [=](double x, double y) {
    const double dented = 1 + 0.08 * std::sin(5 * std::atan2(y - north, x - east));
    const double from_middle = std::hypot(x - east, y - north) * dented;
    return height * std::exp(-std::pow((from_middle - radius) / 130, 2)) -
           120 * std::max(0.0, 1 - from_middle / radius) + 20 * std::sin(x / 90) * std::cos(y / 80);
  };
}

struct Wave {
  double east, north, phase, height;
};

Height fractal(Random& random) {
  std::vector<Wave> waves;
  double length = 1600, height = 115;
  for (int octave = 0; octave < 6; ++octave, length /= 1.9, height /= 1.75)
    for (int i = 0; i < 4; ++i) {
      const double course = random.uniform(0, kWholeTurn), number = kWholeTurn / length;
      waves.push_back({number * std::cos(course), number * std::sin(course),
                       random.uniform(0, kWholeTurn), height});
    }
  return [=](double x, double y) {
    double z = 0;
    for (const Wave& wave : waves)
      z += wave.height * std::sin(wave.east * x + wave.north * y + wave.phase);
    return z;
  };
}

struct Spike {
  double east, north, height, radius;
};

Height spikes(Random& random) {
  std::vector<Spike> all;
  for (int i = 0; i < 70; ++i)
    all.push_back({random.uniform(-kHalfGround, kHalfGround),
                   random.uniform(-kHalfGround, kHalfGround), random.uniform(80, 350),
                   random.uniform(40, 110)});
  return [=](double x, double y) {
    double z = 20 * std::sin(x / 120) + 20 * std::cos(y / 130);
    for (const Spike& spike : all)
      z = std::max(z,
                   spike.height * (1 - std::hypot(x - spike.east, y - spike.north) / spike.radius));
    return z;
  };
}

world::VehicleModel patient(world::VehicleModel vehicle) {
  vehicle.energy.capacity *= 100;
  return vehicle;
}

/// Turns of 40 m; climbs a metre in five.
world::VehicleModel a_quick_plane() {
  world::VehicleModel vehicle = patient(a_blimp());
  vehicle.min_speed = 8;
  vehicle.cruise_speed = 15;
  vehicle.max_speed = 25;
  vehicle.min_turn_radius = 40;
  vehicle.climb_rate = 3;
  vehicle.descent_rate = 4;
  return vehicle;
}

/// A place 50 m above the ground.
Vector3 any_place(const world::World& world, Random& random) {
  const double x = random.uniform(-1250, 1250), y = random.uniform(-1250, 1250);
  return {x, y, world.terrain.elevation(x, y) + 50};
}

/// Pairs of places; how many of them each planner has a way for.
int compare(const world::World& world, Random& random, const world::VehicleModel& vehicle,
            int pairs, const std::string& where) {
  int both = 0;
  for (int pair = 0; pair < pairs; ++pair) {
    refiners::PathQuery query;
    query.vehicle = vehicle;
    query.clearance = 20;
    query.from = any_place(world, random);
    query.to = any_place(world, random);
    const refiners::Setting setting{.world = world, .budget = {}};

    const auto voxels = refiners::VoxelPathPlanner().plan(query, setting);
    const auto trees = SamplingPathPlanner().plan(query, setting);

    if (!trees) continue;
    EXPECT_TRUE(voxels) << where << pair << ": " << voxels.error().why;
    if (!voxels) continue;
    const refiners::Way& way = voxels->task.way;
    EXPECT_TRUE(refiners::is_flyable(way, query.vehicle, 0, 0.5)) << where << pair;
    for (std::size_t i = 1; i < way.size(); ++i)
      EXPECT_GE((way[i] - way[i - 1]).norm(), 1) << where << pair << ", leg " << i;
    EXPECT_LE(voxels->task.length, 1.05 * trees->task.length) << where << pair;
    ++both;
  }
  return both;
}

/// Climbs turned in whole circles made 2 of 36 ways over the first three saw-toothed grounds 6 %
/// longer than those of the sampling planner.
TEST(BothPlanners, GiveWaysOfAboutTheSameLengthOverEachKindOfRoughGroundToWhatCannotHover) {
  const std::vector<std::pair<std::string, Height (*)(Random&)>> kinds = {
      {"saw teeth", saw_teeth}, {"canyons", canyons}, {"terraces", terraces},
      {"crater", crater},       {"fractal", fractal}, {"spikes", spikes}};
  const bool all = skein::testing::long_tests();
  int both = 0;
  for (const auto& [kind, height] : kinds)
    for (std::uint64_t seed = 1; seed <= (all ? 2 : 1); ++seed) {
      Random random(seed, kind);
      const world::World world = world_over(height(random));
      const std::string where = kind + " " + std::to_string(seed) + ", ";
      both += compare(world, random, a_quick_plane(), all ? 3 : 1, where + "plane ");
      both += compare(world, random, patient(a_blimp()), all ? 3 : 1, where + "blimp ");
    }
  EXPECT_GE(both, all ? 50 : 8);
}

/// Whoever crosses a ridge higher than it asks for turns the more for it: these two were 12 and 8 %
/// longer than sampled ways.
TEST(BothPlanners, CrossTheRidgesOfFractalGroundAboutAsLow) {
  const std::string kind = "fractal";
  for (const std::uint64_t seed : {10, 11}) {
    Random random(seed, kind);
    const world::World world = world_over(fractal(random));
    for (int place = 0; place < 8; ++place) any_place(world, random);
    EXPECT_EQ(compare(world, random, patient(a_blimp()), 1, kind + std::to_string(seed)), 1);
  }
}

}  // namespace
}  // namespace skein::sampling
