// SPDX-License-Identifier: Apache-2.0
// Ways over the ground.
#include "skein/refiners/driving.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "skein/foundation/random.hpp"
#include "skein/refiners/tour.hpp"

namespace skein::refiners {
namespace {

using ::testing::HasSubstr;
using world::Vector3;

world::VehicleModel robot(double steepest) {
  world::VehicleModel vehicle;
  vehicle.kind = world::VehicleKind::kGround;
  vehicle.ground = world::GroundModel{steepest, 1};
  vehicle.cruise_speed = 2;
  vehicle.max_speed = 3;
  vehicle.climb_rate = vehicle.descent_rate = 3 * std::tan(steepest);
  vehicle.acceleration = 1;
  vehicle.yaw_rate = 1;
  vehicle.energy.capacity = 1e6;
  vehicle.energy.hover_power = vehicle.energy.ground_power = 50;
  vehicle.energy.cruise_power = 150;
  vehicle.energy.climb_power = 200;
  return vehicle;
}

world::World ground_with(const std::vector<world::HillSpec>& hills) {
  world::TerrainSpec spec;
  spec.east = spec.north = 600;
  spec.hills = hills;
  return world::World{{}, world::Terrain(spec), {}, {}, {}, {}, {}, {}, {}};
}

Outcome<Path> driven(const world::World& world, const world::VehicleModel& vehicle,
                     const Vector3& from, const Vector3& to) {
  const world::Airspace map = drivable_ground(world.terrain, vehicle, world.volumes);
  PathQuery query;
  query.vehicle = vehicle;
  query.from = from;
  query.to = to;
  return DrivingPlanner(map).plan(query, {world, {}, 1, nullptr});
}

double steepest_on(const Way& way, const world::Terrain& terrain) {
  double steepest = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3 step = way[i] - way[i - 1];
    const int pieces = 1 + static_cast<int>(step.norm() / 0.5);
    for (int k = 0; k <= pieces; ++k) {
      const Vector3 at = way[i - 1] + step * k / pieces;
      steepest = std::max(steepest, terrain.slope(at.x(), at.y()));
    }
  }
  return steepest;
}

double level_length(const Way& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).head<2>().norm();
  return length;
}

const world::HillSpec kHill{{300, 300}, 30, 120};  // up to 21 degrees

TEST(Driving, OverLevelGroundLeadsStraightThere) {
  const auto path = driven(ground_with({}), robot(0.2), {20, 30, 0}, {500, 400, 0});

  ASSERT_TRUE(path) << path.error().why;
  EXPECT_THAT(path->task.way, ::testing::ElementsAre(Vector3(20, 30, 0), Vector3(500, 400, 0)));
}

TEST(Driving, WhoClimbsDrivesOverTheHillWhoDoesNotAroundIt) {
  const world::World world = ground_with({kHill});
  const auto over = driven(world, robot(0.5), {100, 290, 0}, {500, 310, 0});
  const auto around = driven(world, robot(0.15), {100, 290, 0}, {500, 310, 0});

  ASSERT_TRUE(over && around);
  EXPECT_LT(level_length(over->task.way), 401);
  EXPECT_GT(level_length(around->task.way), 410);
  EXPECT_GT(over->task.energy, 0);
}

TEST(Driving, UpAHillTakesMoreEnergyThanOnTheLevel) {
  const auto level = driven(ground_with({}), robot(0.5), {100, 300, 0}, {300, 300, 0});
  const auto up = driven(ground_with({kHill}), robot(0.5), {100, 300, 0}, {300, 300, 0});

  ASSERT_TRUE(level && up);
  EXPECT_GT(up->task.energy, level->task.energy);
}

// Law: no ground on a way is too steep, each of its points is on the ground, it goes from one to
// the other; and whoever climbs more needs no longer way.
TEST(Driving, WaysAmongRandomHillsAreNowhereTooSteep) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed, "driving");
    std::vector<world::HillSpec> hills;
    for (int i = 0; i < 6; ++i)
      hills.push_back({{random.uniform(0, 600), random.uniform(0, 600)},
                       random.uniform(5, 50),
                       random.uniform(50, 160)});
    const world::World world = ground_with(hills);
    const Vector3 from(random.uniform(20, 580), random.uniform(20, 580), 0);
    const Vector3 to(random.uniform(20, 580), random.uniform(20, 580), 0);
    const double weak = 0.2, strong = 0.4;
    if (world.terrain.slope(from.x(), from.y()) > weak) continue;
    const auto one = driven(world, robot(weak), from, to);
    const auto other = driven(world, robot(strong), from, to);
    if (!one) continue;
    ++found;
    ASSERT_TRUE(other) << "seed " << seed << ": " << other.error().why;
    EXPECT_LE(steepest_on(one->task.way, world.terrain), weak) << "seed " << seed;
    EXPECT_LE(steepest_on(other->task.way, world.terrain), strong) << "seed " << seed;
    EXPECT_LE(level_length(other->task.way), 1.02 * level_length(one->task.way) + 10)
        << "seed " << seed;
    EXPECT_LT((one->task.way.front() - on_ground(world.terrain, from)).norm(), 1e-6);
    EXPECT_LT((one->task.way.back() - on_ground(world.terrain, to)).norm(), 1e-6);
    for (const Vector3& at : one->task.way)
      EXPECT_NEAR(at.z(), world.terrain.elevation(at.x(), at.y()), 1e-9);
  }
  EXPECT_GT(found, 20);
}

TEST(Driving, AVolumeThatReachesDownIsDrivenAroundOneInTheAirIsNot) {
  world::World world = ground_with({});
  world.volumes.push_back({"closed", {{250, 200}, {350, 200}, {350, 400}, {250, 400}}, 0, 50, {}});
  const auto around = driven(world, robot(0.2), {100, 300, 0}, {500, 300, 0});
  world.volumes.front().floor = 20;
  const auto under = driven(world, robot(0.2), {100, 300, 0}, {500, 300, 0});

  ASSERT_TRUE(around && under);
  EXPECT_GT(level_length(around->task.way), 430);
  EXPECT_LT(level_length(under->task.way), 401);
  for (const Vector3& at : around->task.way)
    EXPECT_FALSE(world::contains(world.volumes.front().polygon, at.head<2>()));
}

TEST(Driving, ToGroundThatIsTooSteepItSaysHowSteepThatIs) {
  const world::World world = ground_with({kHill});
  const auto path = driven(world, robot(0.15), {100, 290, 0}, {240, 300, 0});

  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().kind, RefusalKind::kBlocked);
  EXPECT_THAT(path.error().why, HasSubstr("slopes by"));
}

TEST(Driving, WhoStandsOnGroundThatIsTooSteepDrivesOff) {
  const auto path = driven(ground_with({kHill}), robot(0.15), {240, 300, 0}, {100, 290, 0});

  EXPECT_TRUE(path) << path.error().why;
}

}  // namespace
}  // namespace skein::refiners
