// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/voxel_path_planner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "path/builders.hpp"
#include "path/voxel_worlds.hpp"
#include "skein/refiners/flyable.hpp"

namespace skein::refiners {
namespace {

using testing::free_voxel;
using testing::random_world;
using testing::samples_are_free;
using world::Vector3;
using world::Volume;
using world::World;

Outcome<Path> planned(const PathQuery& query, const World& world) {
  return refine(query, Setting{world, {}, 1, nullptr});
}

/// Points every 10 cm along a way.
std::vector<Vector3> samples(const Way& way) {
  std::vector<Vector3> points;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3 step = way[i] - way[i - 1];
    const int count = 1 + static_cast<int>(step.norm() / 0.1);
    for (int k = 0; k <= count; ++k) points.push_back(way[i - 1] + step * k / count);
  }
  return points;
}

double distance_to(const world::Polygon& polygon, const world::Vector2& point) {
  if (world::contains(polygon, point)) return 0;
  double least = INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const world::Vector2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double along = std::clamp(edge.dot(point - polygon[i]) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (polygon[i] + along * edge - point).norm());
  }
  return least;
}

/// By the world itself, not by voxels.
void expect_clear(const PathQuery& query, const World& world, const Way& way) {
  const double radius = query.vehicle.body_radius;
  for (const Vector3& at : samples(way)) {
    const double height = at.z() - world.terrain.elevation(at.x(), at.y());
    ASSERT_GE(height, std::max(query.clearance, radius) - 1e-6) << at.transpose();
    ASSERT_LE(height, query.vehicle.ceiling + 1e-6);
    for (const Volume& volume : world.volumes) {
      const bool level = at.z() >= volume.floor - radius && at.z() <= volume.ceiling + radius;
      if (!level) continue;
      ASSERT_GT(distance_to(volume.polygon, at.head<2>()), radius) << volume.name;
    }
  }
}

TEST(VoxelPathPlanner, FliesStraightWhereItCan) {
  const PathQuery query = testing::query({52, 47, 33}, {511, 430, 91});

  const auto outcome = planned(query, testing::flat_world());

  ASSERT_TRUE(outcome.has_value()) << outcome.error().why;
  EXPECT_THAT(outcome->task.way, ::testing::ElementsAre(query.from, query.to));
  EXPECT_DOUBLE_EQ(outcome->cost, (query.to - query.from).norm());
  EXPECT_DOUBLE_EQ(outcome->task.length, outcome->cost);
  EXPECT_GT(outcome->task.graph_cost, 0.9 * outcome->cost);
  EXPECT_GT(outcome->task.energy, 0);
  EXPECT_LT(outcome->duration.least, outcome->duration.expected);
  EXPECT_GT(outcome->effort.steps, 0U);
  EXPECT_FALSE(outcome->effort.cut_short);
}

TEST(VoxelPathPlanner, StaysWhereItIs) {
  const PathQuery query = testing::query({52, 47, 33}, {52, 47, 33});

  const auto outcome = planned(query, testing::flat_world());

  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->cost, 0);
}

TEST(VoxelPathPlanner, RepeatsNoPointInSuccession) {
  for (const auto& vehicle : {testing::helicopter(), testing::plane()}) {
    World world = testing::flat_world();
    world.volumes.push_back(testing::wall("wall", 290, 0, 310, 500));
    PathQuery query = testing::query({55, 45, 35}, {515, 435, 95});  // centres of voxels
    query.vehicle = vehicle;

    const auto round = planned(query, world);
    query.to = {62, 51, 35};
    const auto straight = planned(query, world);
    query.to = query.from;
    const auto nowhere = planned(query, world);

    ASSERT_TRUE(round && straight && nowhere);
    for (const Way& way : {round->task.way, straight->task.way, nowhere->task.way})
      for (std::size_t i = 1; i < way.size(); ++i) EXPECT_NE(way[i - 1], way[i]);
    EXPECT_EQ(round->task.way.front(), query.from);
    EXPECT_EQ(round->task.way.back(), Vector3(515, 435, 95));
    EXPECT_THAT(nowhere->task.way, ::testing::ElementsAre(query.from));
  }
}

TEST(VoxelPathPlanner, GivesTheSameWaysThroughAnAirspaceBuiltBefore) {
  World world = testing::hilly_world({{{300, 300}, 120, 200}});
  world.volumes.push_back(testing::wall("wall", 100, 100, 130, 500));
  for (const auto& vehicle : {testing::helicopter(), testing::plane()}) {
    PathQuery query = testing::query({52, 247, 33}, {511, 330, 51});
    query.vehicle = vehicle;
    const Setting setting{world, {}, 1, nullptr};
    const auto airspace = airspace_of(query, setting);
    const VoxelPathPlanner prepared(*airspace);

    for (const Vector3& to : {Vector3(511, 330, 51), Vector3(300, 560, 44), Vector3(560, 60, 3)}) {
      query.to = to;
      const auto one = prepared.plan(query, setting), other = planned(query, world);

      ASSERT_TRUE(one && other) << (one ? other : one).error().why;
      EXPECT_EQ(one->task.way, other->task.way);
      EXPECT_EQ(one->cost, other->cost);
    }
    query.to = {115, 300, 50};
    EXPECT_EQ(prepared.plan(query, setting).error(), planned(query, world).error());
  }
}

TEST(VoxelPathPlanner, KeepsItsDistanceFromGroundAndVolumes) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<world::HillSpec> hills;
    for (int i = 0; i < 5; ++i)
      hills.push_back({{random.uniform(0, 600), random.uniform(0, 600)},
                       random.uniform(20, 150),
                       random.uniform(60, 200)});
    World world = testing::hilly_world(hills);
    for (int i = 0; i < 6; ++i) {
      const double x = random.uniform(0, 500), y = random.uniform(0, 500);
      world.volumes.push_back(testing::wall(std::to_string(i), x, y, x + random.uniform(10, 150),
                                            y + random.uniform(10, 150)));
      if (random.chance(0.5)) world.volumes.back().ceiling = random.uniform(20, 150);
    }
    const auto end = [&] {
      const double x = random.uniform(5, 595), y = random.uniform(5, 595);
      return Vector3(x, y, world.terrain.elevation(x, y) + random.uniform(12, 40));
    };
    PathQuery query = testing::query(end(), end());
    query.vehicle.body_radius = random.uniform(0, 5);
    query.vehicle.ceiling = 120;
    query.clearance = random.uniform(0, 10);

    const auto outcome = planned(query, world);

    if (!outcome) continue;
    expect_clear(query, world, outcome->task.way);
    EXPECT_EQ(outcome->task.way.front(), query.from);
    EXPECT_EQ(outcome->task.way.back(), query.to);
    EXPECT_EQ(outcome->task.way, planned(query, world)->task.way) << "the same twice";
  }
}

TEST(VoxelPathPlanner, StartsWhereOnlyPartOfTheVoxelIsFree) {
  const World world = testing::hilly_world({{{300, 300}, 60, 100}});
  const double ground = world.terrain.elevation(244, 304);
  const PathQuery query = testing::query({244, 304, ground + 4}, {560, 300, 60});
  const auto airspace = airspace_of(query, Setting{world, {}, 1, nullptr});
  ASSERT_FALSE(airspace->is_free(query.from)) << "or the case shows nothing";

  const auto outcome = planned(query, world);

  ASSERT_TRUE(outcome.has_value()) << outcome.error().why;
  expect_clear(query, world, outcome->task.way);
  EXPECT_LT(outcome->task.length, 1.1 * (query.to - query.from).norm());
}

TEST(VoxelPathPlanner, AvoidsWhatOthersReserved) {
  const World world = testing::flat_world();
  PathQuery query = testing::query({50, 300, 50}, {550, 300, 50});
  query.reserved = {testing::wall("", 250, 200, 350, 400)};

  const auto outcome = planned(query, world);

  ASSERT_TRUE(outcome.has_value());
  World blocked = world;
  blocked.volumes = query.reserved;
  expect_clear(query, blocked, outcome->task.way);
  EXPECT_GT(outcome->task.length, 500);
}

TEST(VoxelPathPlanner, MindsAVolumeOnlyWhileItMayBeThere) {
  World world = testing::flat_world();
  world.volumes = {testing::wall("range", 250, 0, 350, 500)};
  const auto length_when = [&](double from, double until) {
    world.volumes[0].when = {MissionTime::seconds(from), MissionTime::seconds(until)};
    PathQuery query = testing::query({50, 300, 50}, {550, 300, 50});
    query.depart = MissionTime::seconds(1000);
    return planned(query, world)->task.length;
  };

  // It takes from 13 s on to get there (200 m at 15 m/s) and 50 s to arrive; it leaves the volume
  // 13 s before that at the latest.
  EXPECT_GT(length_when(900, 1015), 500);
  EXPECT_DOUBLE_EQ(length_when(900, 1013), 500);
  EXPECT_GT(length_when(1036, 1200), 500);
  EXPECT_DOUBLE_EQ(length_when(1037, 1200), 500);
}

TEST(VoxelPathPlanner, MindsAVolumeThatComesWhileItGoesRoundAnother) {
  World world = testing::flat_world();
  world.volumes = {testing::wall("always", 250, 0, 350, 520),
                   testing::wall("later", 400, 250, 450, 600)};
  world.volumes[1].when.from = MissionTime::seconds(52);
  const PathQuery query = testing::query({50, 300, 50}, {550, 300, 50});

  const auto outcome = planned(query, world);

  ASSERT_TRUE(outcome.has_value());
  expect_clear(query, world, outcome->task.way);
}

TEST(VoxelPathPlanner, GivesFlyableWaysToVehiclesThatCannotHover) {
  World world = testing::flat_world();
  world.volumes = {testing::wall("hall", 250, 100, 350, 600)};
  PathQuery query = testing::query({50, 400, 50}, {550, 400, 60});
  query.vehicle = testing::plane();
  query.heading_from = M_PI / 2;

  const auto outcome = planned(query, world);

  ASSERT_TRUE(outcome.has_value()) << outcome.error().why;
  EXPECT_TRUE(is_flyable(outcome->task.way, query.vehicle, query.speed, 0.5));
  expect_clear(query, world, outcome->task.way);
  const Vector3 first = outcome->task.way[1] - outcome->task.way[0];
  EXPECT_NEAR(std::atan2(first.y(), first.x()), M_PI / 2, 0.3);
}

TEST(VoxelPathPlanner, AsksThePlannerOfTheSetting) {
  struct Refuser final : PathPlanner {
    Outcome<Path> plan(const PathQuery&, const Setting&) const override {
      return refuse(RefusalKind::kUnreachable, "to", "asked");
    }
  };
  const Refuser refuser;
  const World world = testing::flat_world();

  const auto outcome =
      refine(testing::query({1, 1, 1}, {2, 2, 2}), Setting{world, {}, 1, &refuser});

  ASSERT_FALSE(outcome.has_value());
  EXPECT_EQ(outcome.error().why, "asked");
}

TEST(FindWay, IsNeverDearerThanTheGraphsWayPulledStraight) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    testing::Mixture mixture;
    mixture.blocked = random.uniform(0.02, 0.3);
    mixture.boxes = 30;
    mixture.dear = seed % 2 == 0 ? 0 : 0.5;
    const auto airspace = random_world(random, testing::cube(24, 2), mixture);
    const auto from = free_voxel(airspace, random), to = free_voxel(airspace, random);

    const VoxelWay found = find_way(airspace, airspace.centre(from), airspace.centre(to), Budget());

    if (!found.found) continue;
    EXPECT_LE(found.cost, found.graph_cost * (1 + 1e-9));
    EXPECT_TRUE(samples_are_free(airspace, found.way));
  }
}

}  // namespace
}  // namespace skein::refiners
