// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/evaluate.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::helicopter;
using testing::level_world;
using world::Vector3;

EvaluateQuery query_along(Way way) {
  EvaluateQuery query;
  query.vehicle = helicopter();
  query.way = std::move(way);
  return query;
}

world::Volume box(std::string name, double west, double east) {
  world::Volume volume;
  volume.name = std::move(name);
  volume.polygon = {{west, -50}, {east, -50}, {east, 50}, {west, 50}};
  return volume;
}

TEST(Evaluate, MeasuresAWay) {
  const world::World world = level_world();
  const EvaluateQuery query = query_along({{0, 0, 50}, {300, 0, 50}, {300, 0, 90}, {300, 90, 70}});

  const auto found = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(found);
  const Flight flight = estimate_flight(query.way, query.vehicle, world.wind);
  EXPECT_DOUBLE_EQ(found->task.length, flight.length);
  EXPECT_DOUBLE_EQ(found->task.energy, flight.energy);
  EXPECT_EQ(found->duration, flight.duration);
  EXPECT_NEAR(found->cost, 30 + 10 + 9, 1e-6);
  EXPECT_DOUBLE_EQ(found->task.climb, 40);
  EXPECT_DOUBLE_EQ(found->task.least_height, 50);
  EXPECT_TRUE(found->task.obstructions.empty());
  EXPECT_TRUE(found->task.limits.empty());
}

// Whenever the clock runs out: all that stands in the way is told, or that the time was up.
TEST(Evaluate, NeverLeavesOutAVolumeForWantOfTime) {
  world::World world = level_world();
  for (int i = 0; i < 2000; ++i) world.volumes.push_back(box("far", 1000, 1010));
  world.volumes.push_back(box("last", 100, 150));
  const EvaluateQuery query = query_along({{0, 0, 50}, {300, 0, 50}});
  bool late = false, in_time = false;
  for (int asked = 0; asked < 12; ++asked) {
    Setting setting{.world = world, .budget = {}};
    setting.budget.time_is_up = [left = asked]() mutable { return left-- <= 0; };

    const auto found = refine(query, setting);

    (found ? in_time : late) = true;
    if (found)
      EXPECT_EQ(found->task.obstructions.size(), 1U) << asked;
    else
      EXPECT_EQ(found.error().kind, RefusalKind::kBudgetExhausted);
  }
  EXPECT_TRUE(late && in_time);
}

TEST(Evaluate, TellsWhereAWayMeetsTheGround) {
  const world::World world = level_world();
  EvaluateQuery query = query_along({{0, 0, 50}, {100, 0, 50}, {200, 0, -50}});
  query.clearance = 10;

  const auto found = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(found);
  ASSERT_EQ(found->task.obstructions.size(), 1U);
  EXPECT_EQ(found->task.obstructions[0].leg, 1U);
  EXPECT_EQ(found->task.obstructions[0].by, "ground");
  EXPECT_NEAR(found->task.obstructions[0].at.x(), 140, 1e-6);
  EXPECT_DOUBLE_EQ(found->task.least_height, -50);
}

TEST(Evaluate, TellsTheFirstPlaceInEachVolumeOfEachLeg) {
  world::World world = level_world();
  world.volumes = {box("one", 100, 150), box("two", 300, 350)};
  EvaluateQuery query = query_along({{0, 0, 50}, {200, 0, 50}, {400, 0, 50}});
  query.reserved = {box("ours", 140, 240)};

  const auto found = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(found);
  const auto& all = found->task.obstructions;
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].by, "one");
  EXPECT_NEAR(all[0].at.x(), 100, 1e-9);
  EXPECT_EQ(all[1].by, "ours");
  EXPECT_NEAR(all[1].at.x(), 140, 1e-9);
  EXPECT_EQ(all[2].by, "two");
  EXPECT_EQ(all[3].by, "ours");
  EXPECT_NEAR(all[3].at.x(), 200, 1e-9);
}

TEST(Evaluate, LeavesOutVolumesThatHoldAtAnotherTime) {
  world::World world = level_world();
  world.volumes = {box("over", 100, 150), box("later", 100, 150), box("now", 100, 150)};
  world.volumes[0].when.until = MissionTime::seconds(1000);
  world.volumes[1].when.from = MissionTime::seconds(1100);
  world.volumes[2].when = {MissionTime::seconds(1005), MissionTime::seconds(1020)};
  EvaluateQuery query = query_along({{0, 0, 50}, {200, 0, 50}});
  query.depart = MissionTime::seconds(1000);

  const auto found = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(found);
  ASSERT_EQ(found->task.obstructions.size(), 1U);
  EXPECT_EQ(found->task.obstructions[0].by, "now");
}

TEST(Evaluate, SaysWhichLimitsOfTheVehicleAreBroken) {
  const world::World world = level_world();
  const auto limits_of = [&](const EvaluateQuery& query) {
    const auto found = refine(query, {.world = world, .budget = {}});
    return found ? found->task.limits : std::vector<std::string>{"refused"};
  };
  EvaluateQuery high = query_along({{0, 0, 50}, {100, 0, 600}});
  EvaluateQuery fast = query_along({{0, 0, 50}, {100, 0, 50}});
  fast.speed = 30;
  EvaluateQuery hungry = fast;
  hungry.speed = 0;
  hungry.vehicle.energy.capacity = 1000;
  EvaluateQuery steep = query_along({{0, 0, 50}, {100, 0, 100}});
  steep.vehicle = testing::fixed_wing();
  EvaluateQuery sharp = query_along({{0, 0, 50}, {500, 0, 50}, {0, 10, 50}});
  sharp.vehicle = testing::fixed_wing();

  EXPECT_NE(limits_of(high).at(0).find("ceiling"), std::string::npos);
  EXPECT_NE(limits_of(fast).at(0).find("above the greatest"), std::string::npos);
  EXPECT_NE(limits_of(hungry).at(0).find("energy"), std::string::npos);
  EXPECT_NE(limits_of(steep).at(0).find("climbs"), std::string::npos);
  EXPECT_NE(limits_of(sharp).at(0).find("sharper"), std::string::npos);
}

TEST(Evaluate, RefusesFiguresThatMakeNoSenseByTheirFields) {
  const world::World world = level_world();
  const auto field_of = [&](auto spoil) {
    EvaluateQuery query = query_along({{0, 0, 50}, {100, 0, 50}});
    spoil(query);
    const auto found = refine(query, {.world = world, .budget = {}});
    return found ? "none" : found.error().field;
  };

  EXPECT_EQ(field_of([](EvaluateQuery& q) { q.way.pop_back(); }), "way");
  EXPECT_EQ(
      field_of([](EvaluateQuery& q) { q.way[1].x() = std::numeric_limits<double>::infinity(); }),
      "way.1");
  EXPECT_EQ(field_of([](EvaluateQuery& q) { q.speed = -2; }), "speed");
  EXPECT_EQ(field_of([](EvaluateQuery& q) { q.clearance = -2; }), "clearance");
  EXPECT_EQ(field_of([](EvaluateQuery& q) { q.vehicle.cruise_speed = 0; }), "vehicle.speed.cruise");
  EXPECT_EQ(field_of([](EvaluateQuery& q) { q.reserved.emplace_back(); }), "reserved.0.polygon");
}

}  // namespace
}  // namespace skein::refiners
