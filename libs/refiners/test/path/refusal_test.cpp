// SPDX-License-Identifier: Apache-2.0
// Every reason for which path refuses a query.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "path/builders.hpp"

namespace skein::refiners {
namespace {

using ::testing::HasSubstr;

const double kNan = std::nan("");

Refusal refusal_of(const PathQuery& query, const world::World& world, const Budget& budget = {}) {
  const auto outcome = refine(query, Setting{world, budget, 1, nullptr});
  return outcome ? Refusal{RefusalKind::kBadQuery, "none", "not refused"} : outcome.error();
}

void expect_bad(const std::string& field, const std::function<void(PathQuery&)>& spoil) {
  SCOPED_TRACE(field);
  PathQuery query = testing::query({50, 50, 50}, {500, 500, 50});
  spoil(query);

  const Refusal refusal = refusal_of(query, testing::flat_world());

  EXPECT_EQ(refusal.kind, RefusalKind::kBadQuery);
  EXPECT_EQ(refusal.field, field);
  EXPECT_NE(refusal.why, "");
}

TEST(PathRefusal, NamesTheFieldThatMakesNoSense) {
  expect_bad("from", [](PathQuery& query) { query.from.x() = kNan; });
  expect_bad("to", [](PathQuery& query) { query.to.z() = -INFINITY; });
  expect_bad("heading_from", [](PathQuery& query) { query.heading_from = kNan; });
  expect_bad("heading_to", [](PathQuery& query) { query.heading_to = kNan; });
  expect_bad("clearance", [](PathQuery& query) { query.clearance = -1; });
  expect_bad("speed", [](PathQuery& query) { query.speed = -3; });
  expect_bad("speed", [](PathQuery& query) { query.speed = kNan; });
  expect_bad("vehicle.speed.cruise", [](PathQuery& query) { query.vehicle.cruise_speed = 0; });
  expect_bad("vehicle.climb_rate", [](PathQuery& query) { query.vehicle.climb_rate = -1; });
  expect_bad("vehicle.body_radius", [](PathQuery& query) { query.vehicle.body_radius = kNan; });
}

TEST(PathRefusal, NamesTheVolumeOrRelayThatMakesNoSense) {
  expect_bad("reserved.0.polygon", [](PathQuery& query) {
    query.reserved = {testing::wall("", 0, 0, 1, 1)};
    query.reserved[0].polygon = {{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  });
  expect_bad("reserved.1.ceiling", [](PathQuery& query) {
    query.reserved = {testing::wall("", 0, 0, 1, 1), testing::wall("", 0, 0, 1, 1)};
    query.reserved[1].floor = 30;
    query.reserved[1].ceiling = 20;
  });
  expect_bad("contact.with", [](PathQuery& query) { query.contact = Contact{{kNan, 0, 0}, {}}; });
  expect_bad("contact.relays.1", [](PathQuery& query) {
    query.contact = Contact{{0, 0, 10}, {{0, 0, 0}, {0, kNan, 0}}};
  });
  expect_bad("contact.relays", [](PathQuery& query) {
    query.contact = Contact{{0, 0, 10}, std::vector<world::Vector3>(65, {0, 0, 0})};
  });
}

TEST(PathRefusal, NamesAnAirspaceThatMakesNoSense) {
  world::World world = testing::flat_world();
  world.airspace.size = {60, 0, 20};

  const Refusal refusal = refusal_of(testing::query({50, 50, 50}, {90, 90, 50}), world);

  EXPECT_EQ(refusal.kind, RefusalKind::kBadQuery);
  EXPECT_EQ(refusal.field, "world.airspace");
}

TEST(PathRefusal, SaysWhatBlocksAnEnd) {
  world::World world = testing::hilly_world({{{300, 300}, 80, 150}});
  world.volumes = {testing::wall("the depot", 400, 400, 450, 450)};
  const auto refused = [&](const world::Vector3& to) {
    PathQuery query = testing::query({50, 50, 50}, to);
    query.clearance = 20;
    query.reserved = {testing::wall("convoy", 100, 500, 150, 550)};
    const Refusal refusal = refusal_of(query, world);
    EXPECT_EQ(refusal.kind, RefusalKind::kBlocked);
    EXPECT_EQ(refusal.field, "to");
    return refusal.why;
  };

  EXPECT_THAT(refused({300, 300, 40}), HasSubstr("in the ground"));
  EXPECT_THAT(refused({500, 50, 10}), HasSubstr("over the ground"));
  EXPECT_THAT(refused({420, 420, 60}), HasSubstr("volume 'the depot'"));
  EXPECT_THAT(refused({399.5, 420, 60}), HasSubstr("volume 'the depot'")) << "the body touches it";
  EXPECT_THAT(refused({120, 520, 60}), HasSubstr("reserved.0 ('convoy')"));
  EXPECT_THAT(refused({601, 50, 50}), HasSubstr("outside the airspace"));
}

TEST(PathRefusal, SaysThatAnEndIsAboveTheCeiling) {
  PathQuery query = testing::query({50, 50, 150}, {500, 500, 50});
  query.vehicle.ceiling = 100;

  const Refusal refusal = refusal_of(query, testing::flat_world());

  EXPECT_EQ(refusal.kind, RefusalKind::kBeyondVehicle);
  EXPECT_EQ(refusal.field, "from");
  EXPECT_THAT(refusal.why, HasSubstr("ceiling"));
}

TEST(PathRefusal, SaysThatEveryWayIsClosed) {
  world::World world = testing::flat_world();
  world.volumes = {testing::wall("front", -10, 290, 610, 310)};

  const Refusal refusal = refusal_of(testing::query({50, 50, 50}, {500, 500, 50}), world);

  EXPECT_EQ(refusal.kind, RefusalKind::kUnreachable);
}

TEST(PathRefusal, IsOfASpeedTheVehicleCannotFly) {
  PathQuery query = testing::query({50, 50, 50}, {500, 500, 50});
  query.speed = 16;

  EXPECT_EQ(refusal_of(query, testing::flat_world()).kind, RefusalKind::kBeyondVehicle);
  query.vehicle = testing::plane();
  query.speed = 5;
  EXPECT_EQ(refusal_of(query, testing::flat_world()).field, "speed");
}

TEST(PathRefusal, IsOfAWayThatTakesTooMuchEnergy) {
  PathQuery query = testing::query({50, 50, 50}, {500, 500, 50});
  query.vehicle.energy.capacity = 5e4;

  const Refusal refusal = refusal_of(query, testing::flat_world());

  EXPECT_EQ(refusal.kind, RefusalKind::kBeyondVehicle);
  EXPECT_EQ(refusal.field, "vehicle.energy");
}

TEST(PathRefusal, IsOfAWindTooStrong) {
  world::World world = testing::flat_world();
  world.wind.speed = 20;
  world.wind.toward = M_PI;
  PathQuery query = testing::query({50, 50, 50}, {500, 50, 50});
  query.vehicle.wind_drift = 1;

  const Refusal refusal = refusal_of(query, world);

  EXPECT_EQ(refusal.kind, RefusalKind::kBeyondVehicle);
  EXPECT_THAT(refusal.why, HasSubstr("wind"));
}

TEST(PathRefusal, SaysThatThereIsNoContact) {
  PathQuery query = testing::query({50, 50, 50}, {550, 50, 50});
  query.contact = Contact{{50, 100, 10}, {}};

  const Refusal end = refusal_of(query, testing::flat_world());

  EXPECT_EQ(end.kind, RefusalKind::kNoContact);
  EXPECT_EQ(end.field, "to");

  query.contact = Contact{{50, 50, 10}, {}};
  query.to = {50, 350, 50};
  world::World world = testing::flat_world();
  world.volumes = {testing::wall("front", -10, 190, 500, 210)};
  const Refusal between = refusal_of(query, world);
  EXPECT_EQ(between.kind, RefusalKind::kNoContact);
  EXPECT_EQ(between.field, "contact");
}

TEST(PathRefusal, ComesAtOnceWhenTheTimeIsUp) {
  Budget budget;
  int asked = 0;
  budget.time_is_up = [&] { return ++asked > 0; };

  const Refusal refusal =
      refusal_of(testing::query({50, 50, 50}, {500, 500, 50}), testing::flat_world(), budget);

  EXPECT_EQ(refusal.kind, RefusalKind::kBudgetExhausted);
  EXPECT_LE(asked, 3);
}

TEST(PathRefusal, ComesWithTheLastStep) {
  Budget budget;
  budget.steps = 20;

  const Refusal refusal =
      refusal_of(testing::query({50, 50, 50}, {500, 500, 50}), testing::flat_world(), budget);

  EXPECT_EQ(refusal.kind, RefusalKind::kBudgetExhausted);
}

}  // namespace
}  // namespace skein::refiners
