// SPDX-License-Identifier: Apache-2.0
// The ways of the voxels, judged by FCL; and both planners on the same queries.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "skein/refiners/flyable.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "skein/sampling/collision_scene.hpp"
#include "skein/sampling/sampling_path_planner.hpp"
#include "test_cases.hpp"
#include "worlds.hpp"

namespace skein::sampling {
namespace {

using refiners::PathQuery;
using refiners::Setting;
using world::Vector3;

int cases(int few, int many) { return skein::testing::cases(few, many); }

world::World random_world(Random& random) {
  world::World world = hills(random);
  for (int k = 0; k < 8; ++k) world.volumes.push_back(a_star(random, std::to_string(k)));
  return world;
}

PathQuery random_query(Random& random, const world::World& world) {
  PathQuery query;
  query.vehicle = random.chance(0.5) ? a_helicopter() : a_blimp();
  query.clearance = random.uniform(0, 15);
  const auto at = [&](double x) {
    const double y = random.uniform(50, 950);
    return Vector3(x, y, std::min(195.0, world.terrain.elevation(x, y) + random.uniform(25, 60)));
  };
  query.from = at(random.uniform(50, 200));
  query.to = at(random.uniform(800, 950));
  return query;
}

TEST(VoxelTracks, NeverMeetAnythingByFcl) {
  Random random(1);
  int found = 0;
  const int count = cases(5, 500);
  for (int i = 0; i < count; ++i) {
    const world::World world = random_world(random);
    const PathQuery query = random_query(random, world);

    const auto path =
        refiners::VoxelPathPlanner().plan(query, Setting{.world = world, .budget = {}});

    if (!path) continue;
    ++found;
    const CollisionScene scene(world, {.clearance = query.clearance, .ground_accuracy = 0.05});
    const auto& way = path->task.way;
    // A hair less: ways may touch what the voxels leave free.
    const double radius = query.vehicle.body_radius - 0.06;
    for (std::size_t k = 1; k < way.size(); ++k) {
      const auto conflict = scene.first_conflict(way[k - 1], way[k], radius);
      ASSERT_FALSE(conflict.has_value())
          << conflict->with << " on leg " << k << " of case " << i << ", from "
          << way[k - 1].transpose() << " to " << way[k].transpose();
    }
  }
  RecordProperty("found", found);
  EXPECT_GE(found, count / 4);
}

TEST(BothPlanners, AgreeOnWhatIsEasyAndOnAboutHowLongItIs) {
  Random random(2);
  int both = 0;
  for (int i = 0; i < cases(6, 60); ++i) {
    const world::World world = hills(random, 6);
    PathQuery query = random_query(random, world);
    query.vehicle = a_helicopter();
    const Setting setting{.world = world, .budget = {}};

    const auto voxels = refiners::VoxelPathPlanner().plan(query, setting);
    const auto sampled = SamplingPathPlanner().plan(query, setting);

    if (!voxels || !sampled) continue;
    ++both;
    EXPECT_LE(sampled->task.length, 1.1 * voxels->task.length);
    EXPECT_LE(voxels->task.length, 1.1 * sampled->task.length);
  }
  EXPECT_GE(both, 3);
}

TEST(BothPlanners, FindNoWayThroughAClosedWall) {
  world::World world = a_plain();
  world.volumes = {a_box("wall", {480, -10}, {520, 1010}, -10, 300)};
  PathQuery query;
  query.vehicle = a_helicopter();
  query.from = {100, 100, 55};
  query.to = {900, 100, 55};
  const Setting setting{.world = world, .budget = {.time_is_up = {}, .steps = 2'000'000}};
  const Setting few{.world = world, .budget = {.time_is_up = {}, .steps = 200}};

  const auto voxels = refiners::VoxelPathPlanner().plan(query, setting);
  const auto sampled = SamplingPathPlanner().plan(query, few);

  ASSERT_FALSE(voxels.has_value());
  ASSERT_FALSE(sampled.has_value());
  EXPECT_EQ(voxels.error().kind, refiners::RefusalKind::kUnreachable);
  EXPECT_EQ(sampled.error().kind, refiners::RefusalKind::kBudgetExhausted);
}

/// Ridges and rough ground, rising and falling by about 2 × `relief` within some hundred metres.
world::World steep(std::uint64_t seed, double relief) {
  Random random(seed, "ground");
  world::TerrainSpec spec;
  spec.west = spec.south = -900;
  spec.east = spec.north = 900;
  spec.cell = 30;
  double phases[8];
  for (double& phase : phases) phase = random.uniform(0, 2 * std::numbers::pi);
  const auto corners = world::corners_of(spec);
  for (std::size_t row = 0; row < corners.rows; ++row)
    for (std::size_t column = 0; column < corners.columns; ++column) {
      const double x = -900 + 30 * static_cast<double>(column);
      const double y = -900 + 30 * static_cast<double>(row);
      double z = 0, height = relief / 2, length = 900;
      for (int k = 0; k < 8; k += 2, height /= 3, length /= 2)
        z += height * std::sin(2 * std::numbers::pi *
                                   (x * std::cos(phases[k]) + y * std::sin(phases[k])) / length +
                               phases[k + 1]);
      spec.elevations.push_back(z);
    }
  world::World world = a_plain();
  world.terrain = world::Terrain(spec);
  const double low = world.terrain.lowest(), high = world.terrain.highest() + 200;
  world.airspace = {{-900, -900, low}, 20, {90, 90, static_cast<std::int32_t>((high - low) / 20)}};
  return world;
}

/// Turns of 40 m; climbs a metre in five.
world::VehicleModel a_plane() {
  world::VehicleModel vehicle = a_blimp();
  vehicle.min_speed = 8;
  vehicle.cruise_speed = 15;
  vehicle.max_speed = 25;
  vehicle.min_turn_radius = 40;
  vehicle.climb_rate = 3;
  vehicle.descent_rate = 4;
  vehicle.energy.capacity *= 100;
  return vehicle;
}

/// The eighth is one over which a climb turned in a whole circle was 8 % longer; the last one in
/// which two legs as steep as can be flown end in one of 0.2 m.
std::vector<std::uint64_t> steep_seeds() {
  if (cases(0, 1) == 0) return {1, 2, 8, 16};
  std::vector<std::uint64_t> all(16);
  std::iota(all.begin(), all.end(), 1U);
  return all;
}

TEST(BothPlanners, GiveWaysOfAboutTheSameLengthOverSteepGroundToWhatCannotHover) {
  double sum = 0;
  int both = 0;
  for (const std::uint64_t seed : steep_seeds())
    for (const double relief : {150.0, 300.0}) {
      const world::World world = steep(seed, relief);
      Random random(seed, "places");
      const auto over = [&] {
        const double x = random.uniform(-700, 700), y = random.uniform(-700, 700);
        return Vector3(x, y, world.terrain.elevation(x, y) + 60);
      };
      PathQuery query;
      query.vehicle = a_plane();
      query.clearance = 20;
      query.from = over();
      query.to = over();
      const Setting setting{.world = world, .budget = {}};

      const auto voxels = refiners::VoxelPathPlanner().plan(query, setting);
      const auto trees = SamplingPathPlanner().plan(query, setting);

      if (!trees) continue;
      ASSERT_TRUE(voxels) << "seed " << seed << ": " << voxels.error().why;
      const refiners::Way& way = voxels->task.way;
      EXPECT_TRUE(refiners::is_flyable(way, query.vehicle, 0, 0.5)) << "seed " << seed;
      for (std::size_t i = 1; i < way.size(); ++i)
        EXPECT_GE((way[i] - way[i - 1]).norm(), 1) << "seed " << seed << ", leg " << i;
      const double ratio = voxels->task.length / trees->task.length;
      EXPECT_LE(ratio, 1.05) << "seed " << seed << ", relief " << relief;
      sum += ratio;
      ++both;
    }
  ASSERT_GT(both, 4);
  EXPECT_LE(sum / both, 1.02);
}

/// Ridges of falling height, and every so often a post that stands out.
world::World alpine(std::uint64_t seed) {
  constexpr double kHalf = 1500, kPost = 30;
  Random random(seed, "ridges");
  world::TerrainSpec spec;
  spec.west = spec.south = -kHalf;
  spec.east = spec.north = kHalf;
  spec.cell = kPost;
  struct Ridge {
    double across, along, phase, height;
  };
  std::vector<Ridge> ridges;
  for (const double per_side : {1.5, 2.5, 4.5, 7.5, 13.5})
    for (int i = 0; i < 3; ++i)
      ridges.push_back({per_side * random.uniform(-1, 1), per_side * random.uniform(-1, 1),
                        random.uniform(0, 2 * std::numbers::pi), 420 / per_side});
  const auto corners = world::corners_of(spec);
  for (std::size_t row = 0; row < corners.rows; ++row)
    for (std::size_t column = 0; column < corners.columns; ++column) {
      const double x = static_cast<double>(column) * kPost / kHalf;
      const double y = static_cast<double>(row) * kPost / kHalf;
      double z = random.chance(0.001) ? 120 : 0;
      for (const Ridge& ridge : ridges)
        z += ridge.height *
             (1 - std::abs(std::sin(std::numbers::pi * (ridge.across * x + ridge.along * y) +
                                    ridge.phase)));
      spec.elevations.push_back(z);
    }
  world::World world = a_plain();
  world.terrain = world::Terrain(spec);
  const double low = world.terrain.lowest(), high = world.terrain.highest() + 300;
  world.airspace = {
      {-kHalf, -kHalf, low}, 20, {150, 150, static_cast<std::int32_t>((high - low) / 20)}};
  return world;
}

/// Where its straight ways are too steep it had circled up: by 19 % more in the eighth pair of the
/// second ground, by 28 and 30 % on one of an audit.
TEST(BothPlanners, GiveWaysOfAboutTheSameLengthOverRidgesUpWhichOneCouldCircle) {
  const bool all = skein::testing::long_tests();
  for (std::uint64_t seed = all ? 1 : 2; seed <= (all ? 6 : 2); ++seed) {
    const world::World world = alpine(seed);
    Random random(seed, "places");
    const auto over = [&] {
      const double x = random.uniform(-1300, 1300), y = random.uniform(-1300, 1300);
      return Vector3(x, y, world.terrain.elevation(x, y) + 80);
    };
    for (int pair = 0; pair < (all ? 10 : 8); ++pair) {
      PathQuery query;
      query.vehicle = a_plane();
      query.clearance = 20;
      query.from = over();
      query.to = over();
      if (!all && pair < 6) continue;
      const Setting setting{.world = world, .budget = {}};

      const auto trees = SamplingPathPlanner().plan(query, setting);
      const auto voxels = refiners::VoxelPathPlanner().plan(query, setting);

      if (!trees || !voxels) continue;
      EXPECT_TRUE(refiners::is_flyable(voxels->task.way, query.vehicle, 0, 0.5));
      EXPECT_LE(voxels->task.length, 1.05 * trees->task.length)
          << "seed " << seed << ", pair " << pair;
    }
  }
}

/// Slopes that rise gently and fall steeply, four times as long as steep.
world::World saw_toothed(std::uint64_t seed) {
  constexpr double kHalf = 1440, kPost = 30;
  Random random(seed, "teeth");
  world::TerrainSpec spec;
  spec.west = spec.south = -kHalf;
  spec.east = spec.north = kHalf;
  spec.cell = kPost;
  const double across = random.uniform(0, 2 * std::numbers::pi);
  const double length = random.uniform(300, 700), height = random.uniform(120, 260);
  const auto corners = world::corners_of(spec);
  for (std::size_t row = 0; row < corners.rows; ++row)
    for (std::size_t column = 0; column < corners.columns; ++column) {
      const double x = static_cast<double>(column) * kPost - kHalf;
      const double y = static_cast<double>(row) * kPost - kHalf;
      const double along =
          x * std::cos(across) + y * std::sin(across) + 80 * std::sin((x - y) / 300);
      const double part = along / length - std::floor(along / length);
      spec.elevations.push_back(height * (part < 0.8 ? part / 0.8 : (1 - part) / 0.2));
    }
  world::World world = a_plain();
  world.terrain = world::Terrain(spec);
  const double low = world.terrain.lowest(), high = world.terrain.highest() + 300;
  world.airspace = {
      {-kHalf, -kHalf, low}, 20, {144, 144, static_cast<std::int32_t>((high - low) / 20)}};
  return world;
}

/// An audit's ground of this kind had a leg of 0.35 m, as four ways of 200 here: two legs as steep
/// as can be flown became one that rounding made a hundred millionth too steep; or a short leg lay
/// between two arcs, one way and the other.
TEST(VoxelWays, HaveNoLegUnderAMetreOverSawTeeth) {
  std::vector<std::uint64_t> seeds = {10, 12, 14, 20};  // of ways that had such legs
  for (int seed = 21; seed <= cases(0, 60); ++seed)
    seeds.push_back(static_cast<std::uint64_t>(seed));
  for (const std::uint64_t seed : seeds) {
    const world::World world = saw_toothed(seed);
    Random random(seed, "places");
    const auto over = [&] {
      const double x = random.uniform(-1250, 1250), y = random.uniform(-1250, 1250);
      return Vector3(x, y, world.terrain.elevation(x, y) + 80);
    };
    for (int pair = 0; pair < 10; ++pair) {
      PathQuery query;
      query.vehicle = a_plane();
      query.clearance = 20;
      query.from = over();
      query.to = over();
      const auto voxels = refiners::VoxelPathPlanner().plan(query, {.world = world, .budget = {}});
      if (!voxels) continue;
      const refiners::Way& way = voxels->task.way;
      EXPECT_TRUE(refiners::is_flyable(way, query.vehicle, 0, 0.5));
      for (std::size_t i = 1; i < way.size(); ++i)
        EXPECT_GE((way[i] - way[i - 1]).norm(), 1)
            << "seed " << seed << ", pair " << pair << ", leg " << i << " of " << way.size() - 1;
    }
  }
}

}  // namespace
}  // namespace skein::sampling
