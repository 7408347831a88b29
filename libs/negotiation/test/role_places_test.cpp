// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/role_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skein/foundation/random.hpp"

namespace skein::interaction {
namespace {

using Quantity = SpatialConstraint::Quantity;

/// A ridge between west and east, 60 m high.
world::World hilly(double range) {
  world::TerrainSpec terrain;
  terrain.east = 400;
  terrain.north = 200;
  terrain.cell = 10;
  for (int y = 0; y <= 200; y += 25)
    terrain.hills.push_back({{200.0, static_cast<double>(y)}, 35, 60});
  world::World world{{}, world::Terrain(terrain), {}, {}, {}, {}, {}, {}, {}};
  world.airspace = {world::Vector3::Zero(), 10, {40, 20, 20}};
  world.radio.range = range;
  return world;
}

RolePlaceQuery query() {
  RolePlaceQuery one;
  one.vehicle.cruise_speed = one.vehicle.max_speed = 8;
  one.vehicle.climb_rate = one.vehicle.descent_rate = 3;
  one.vehicle.acceleration = 2;
  one.vehicle.yaw_rate = 1;
  one.vehicle.ceiling = 150;
  one.vehicle.energy.capacity = 1e6;
  world::SensorModel camera;
  camera.device = "visible";
  camera.aperture = 0.3;
  camera.gimballed = true;
  camera.range = 80;
  camera.quality.best_distance = 20;
  camera.quality.at_range = 0.2;
  one.vehicle.sensors = {camera};
  one.from = {50, 100, 30};
  one.clearance = 10;
  return one;
}

ActiveScm within(const std::string& place, Relation relation, double metres) {
  ActiveScm one{"s", {}, {}};
  one.scm.parameters = {{"p", true}};
  one.scm.constraints = {{Quantity::kDistance, {"p"}, relation, Term(metres), 0}};
  one.binding.places["p"] = {place};
  return one;
}

Observer knows(const std::string& name, Position where) {
  return [=](const std::string& asked) -> std::optional<Sighting> {
    if (asked != name) return std::nullopt;
    return Sighting{where, MissionTime()};
  };
}

double distance(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

world::Vector3 vector_of(const Position& p) { return {p[0], p[1], p[2]}; }

TEST(RelayPosition, IsInSightOfBothOverTheRealGround) {
  const world::World world = hilly(300);
  const Position west{40, 100, 5}, east{360, 100, 5};
  ASSERT_LT(world.radio.margin(vector_of(west), vector_of(east), world.terrain), 0);

  const auto found = relay_position(query(), west, east, 0, knows("", {}), {world, {}, 1});

  ASSERT_TRUE(found) << found.error().why;
  for (const Position& end : {west, east}) {
    EXPECT_TRUE(world.terrain.line_of_sight(vector_of(*found), vector_of(end)));
    EXPECT_LE(distance(*found, end), 300);
  }
}

TEST(RelayPosition, KeepsToTheSpatialConstraints) {
  const world::World world = hilly(300);
  const Position west{40, 100, 5}, east{360, 100, 5};
  RolePlaceQuery one = query();
  one.scms = {within("west", Relation::kLess, 190)};

  const auto found = relay_position(one, west, east, 0, knows("west", west), {world, {}, 1});

  ASSERT_TRUE(found) << found.error().why;
  EXPECT_LT(distance(*found, west), 190);
  EXPECT_TRUE(world.terrain.line_of_sight(vector_of(*found), vector_of(east)));
}

TEST(RelayPosition, IsRefusedWhereNobodyCanHearBoth) {
  const world::World world = hilly(120);

  const auto found =
      relay_position(query(), {40, 100, 5}, {360, 100, 5}, 0, knows("", {}), {world, {}, 1});

  ASSERT_FALSE(found);
  EXPECT_NE(found.error().why.find("no position"), std::string::npos);
}

TEST(RelayPosition, BetweenThoseWhoHearEachOtherIsHalfWay) {
  const world::World world = hilly(300);
  const Position one{20, 50, 40}, other{100, 50, 40};

  const auto found = relay_position(query(), one, other, 0, knows("", {}), {world, {}, 1});

  ASSERT_TRUE(found) << found.error().why;
  EXPECT_LT(distance(*found, {60, 50, 40}), 5);
}

TEST(BestView, PerceivesTheTargetWhereTheConstraintsHold) {
  const world::World world = hilly(300);
  const Position fire{60, 60, world.terrain.elevation(60, 60)};
  RolePlaceQuery one = query();
  one.scms = {within("fire", Relation::kGreater, 30)};

  const auto found = best_view(one, "visible", fire, knows("fire", fire), {world, {}, 1});

  ASSERT_TRUE(found) << found.error().why;
  EXPECT_GT(distance(*found, fire), 30);
  EXPECT_LT(distance(*found, fire), 45) << "near is better";
  EXPECT_TRUE(
      world.terrain.line_of_sight(vector_of(*found), vector_of(fire) + world::Vector3(0, 0, 0.01)));
}

/// Of one vehicle that asks again and again.
class ViewAskedForAgain : public ::testing::Test {
 protected:
  bool is_seen(const Position& fire) {
    const Observer sees = [&](const std::string&) { return Sighting{fire, one_.at}; };
    return best_view(one_, "visible", fire, sees, setting(), &known_).has_value();
  }
  /// Whether the refiner searched for it.
  bool searches(const Position& fire) {
    const int before = polled_;
    EXPECT_FALSE(is_seen(fire));
    return polled_ > before;
  }
  refiners::Setting setting() {
    return {world_, {[this] { return ++polled_ > most_; }}, 1};
  }

  world::World world_ = hilly(300);
  Position fire_{60, 60, world_.terrain.elevation(60, 60)};
  RolePlaceQuery one_ = [] {
    RolePlaceQuery far = query();
    far.scms = {within("fire", Relation::kGreater, 90)};  // its camera sees 80 m far
    return far;
  }();
  RefusedViews known_;
  int polled_ = 0, most_ = 1'000'000;
};

TEST_F(ViewAskedForAgain, WhatThereIsNotIsSearchedForOnce) {
  EXPECT_TRUE(searches(fire_));
  one_.from[0] += 5;
  one_.at = MissionTime::seconds(20);
  EXPECT_FALSE(searches(fire_));
}

TEST_F(ViewAskedForAgain, UntilItsTargetHasMoved) {
  ASSERT_TRUE(searches(fire_));
  Position moved = fire_;
  moved[0] += 1;
  EXPECT_TRUE(searches(moved));
  EXPECT_FALSE(searches(fire_)) << "the last few are known";
}

TEST_F(ViewAskedForAgain, UntilAnotherAirIsClosed) {
  world_.volumes = {{"smoke", {{0, 0}, {10, 0}, {10, 10}}, 0, 50, {{}, MissionTime::seconds(90)}}};
  ASSERT_TRUE(searches(fire_));
  ASSERT_FALSE(searches(fire_));
  one_.at = MissionTime::seconds(100);
  EXPECT_TRUE(searches(fire_)) << "it has opened";
}

TEST_F(ViewAskedForAgain, UntilItsConstraintsChange) {
  ASSERT_TRUE(searches(fire_));
  one_.scms = {within("fire", Relation::kGreater, 30)};
  EXPECT_TRUE(is_seen(fire_));
}

TEST_F(ViewAskedForAgain, WhatTimeWasTooShortForIsNotKnown) {
  most_ = 0;
  ASSERT_TRUE(searches(fire_));
  EXPECT_TRUE(searches(fire_));
}

TEST(BestView, IsRefusedWithTheReason) {
  const world::World world = hilly(300);
  RolePlaceQuery one = query();
  EXPECT_FALSE(best_view(one, "radar", {60, 60, 0}, knows("", {}), {world, {}, 1}));

  one.scms = {within("nowhere", Relation::kLess, 30)};
  const auto unknown = best_view(one, "visible", {60, 60, 0}, knows("", {}), {world, {}, 1});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().why, "a place of s is unknown");

  one.scms = {within("fire", Relation::kGreater, 300)};
  EXPECT_FALSE(best_view(one, "visible", {60, 60, 0}, knows("fire", {60, 60, 0}), {world, {}, 1}));
}

}  // namespace
}  // namespace skein::interaction
