// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/viewpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "viewpoint/cases.hpp"

namespace skein::refiners {
namespace {

using ::testing::HasSubstr;
using world::Vector3;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kRight = std::numbers::pi / 2;

/// A target in the middle of a square kilometre of level ground.
ViewpointCase on_the_level() {
  world::TerrainSpec ground;
  ground.east = ground.north = 1000;
  ViewpointCase c{{{}, world::Terrain(ground), {}, {}, {}, {}, {}, {}, {}}, {}};
  c.world.airspace = {{0, 0, -10}, 10, {100, 100, 60}};
  c.query.target = {500, 500, 0};
  c.query.vehicle = a_helicopter();
  c.query.vehicle.sensors = {a_camera()};
  c.query.device = "visible";
  return c;
}

/// A wall 60 m high and some 40 m thick, east of the target.
ViewpointCase behind_a_hill() {
  ViewpointCase c = on_the_level();
  world::TerrainSpec ground = c.world.terrain.spec();
  for (double y = 300; y <= 700; y += 20) ground.hills.push_back({{560, y}, 60, 40});
  c.world.terrain = world::Terrain(ground);
  return c;
}

Outcome<Viewpoints> solve(const ViewpointCase& c, const Budget& budget = {}) {
  return refine(c.query, Setting{c.world, budget, 1, nullptr});
}

ViewPoint best_of(const ViewpointCase& c) {
  const auto found = solve(c);
  EXPECT_TRUE(found) << (found ? "" : found.error().why);
  if (!found) return {};
  EXPECT_TRUE(will_do(c, found->task.points[0].position));
  return found->task.points[0];
}

Refusal refusal_of(const ViewpointCase& c) {
  const auto found = solve(c);
  EXPECT_FALSE(found);
  return found ? Refusal{} : found.error();
}

TEST(Viewpoint, IsAboveATargetOnLevelGround) {
  const ViewPoint best = best_of(on_the_level());

  EXPECT_NEAR(best.quality, 1, 0.003);
  EXPECT_EQ(best.utility, best.quality);
  EXPECT_LT(best.pitch, -1.4);
}

TEST(Viewpoint, CostsAreTakenFromQuality) {
  ViewpointCase c = on_the_level();
  c.query.vehicle.sensors[0].cost = 0.1;
  c.query.from = Vector3(500, 800, 50);
  c.query.cost_of_way = 0.0005;

  const auto found = solve(c);

  ASSERT_TRUE(found);
  const ViewPoint& best = found->task.points[0];
  EXPECT_NEAR(best.utility, best.quality - 0.1 - 0.0005 * (best.position - *c.query.from).norm(),
              1e-12);
  EXPECT_DOUBLE_EQ(found->cost, 1 - best.utility);
}

TEST(Viewpoint, IsNearerWhereTheVehicleIsTheMoreTheWayCosts) {
  ViewpointCase c = on_the_level();
  c.query.from = Vector3(500, 800, 50);
  const double free = (best_of(c).position - *c.query.from).norm();
  c.query.cost_of_way = 0.004;

  EXPECT_LT((best_of(c).position - *c.query.from).norm(), free - 50);
}

TEST(Viewpoint, TakesAsLongAsAStraightFlightThere) {
  ViewpointCase c = on_the_level();
  EXPECT_EQ(solve(c)->duration, DurationInterval{});
  c.query.from = Vector3(500, 800, 50);

  const auto found = solve(c);

  ASSERT_TRUE(found);
  const Way way = {*c.query.from, found->task.points[0].position};
  EXPECT_EQ(found->duration, estimate_flight(way, c.query.vehicle, c.world.wind).duration);
}

TEST(Viewpoint, ASensorThatLooksDownIsKeptAboveItsTarget) {
  ViewpointCase c = on_the_level();
  c.query.vehicle.sensors[0].gimballed = false;
  c.query.vehicle.sensors[0].boresight_pitch = -kRight;
  c.query.vehicle.sensors[0].aperture = 0.3;
  c.query.from = Vector3(900, 500, 50);
  c.query.cost_of_way = 0.01;

  const ViewPoint best = best_of(c);

  const Vector3 offset = best.position - c.query.target;
  EXPECT_LE(std::atan2(offset.head<2>().norm(), offset.z()), 0.3);
  EXPECT_EQ(best.pitch, -kRight);
}

TEST(Viewpoint, AFixedSensorIsTurnedWithItsVehicle) {
  ViewpointCase c = on_the_level();
  c.query.vehicle.sensors[0].gimballed = false;

  const ViewPoint best = best_of(c);

  const world::View view{best.position, world::direction_of(best.heading, best.pitch), 250, 0.35};
  EXPECT_EQ(best.pitch, -0.6);
  EXPECT_TRUE(world::in_view(view, c.query.target));
}

TEST(Viewpoint, AGimballedSensorLooksAtItsTarget) {
  ViewpointCase c = on_the_level();
  c.query.nearest = 150;
  c.query.from = Vector3(300, 350, 40);
  c.query.cost_of_way = 0.001;

  const ViewPoint best = best_of(c);

  const Vector3 toward = (c.query.target - best.position).normalized();
  EXPECT_NEAR((world::direction_of(best.heading, best.pitch) - toward).norm(), 0, 1e-9);
}

TEST(Viewpoint, KeepsItsDistances) {
  ViewpointCase c = on_the_level();
  c.query.nearest = 120;
  EXPECT_NEAR((best_of(c).position - c.query.target).norm(), 120, 1);
  c.query.nearest = 0;
  c.query.farthest = 1e5;

  EXPECT_LE((best_of(c).position - c.query.target).norm(), 250) << "no further than its range";
}

TEST(Viewpoint, SeesOverTheHillOrFromThisSideOfIt) {
  ViewpointCase c = behind_a_hill();
  c.query.from = Vector3(900, 500, 30);
  c.query.cost_of_way = 0.002;
  c.query.nearest = 100;

  const ViewPoint best = best_of(c);

  EXPECT_TRUE(c.world.terrain.line_of_sight(best.position, c.query.target + Vector3(0, 0, 0.1)));
}

TEST(Viewpoint, IncidenceIsThatOnTheSlope) {
  ViewpointCase c = on_the_level();
  world::TerrainSpec ground = c.world.terrain.spec();
  ground.hills = {{{500, 500}, 80, 200}};
  c.world.terrain = world::Terrain(ground);
  c.query.target = {400, 500, c.world.terrain.elevation(400, 500)};
  c.query.nearest = 60;

  EXPECT_LT(best_of(c).position.x(), 380) << "west of a slope that faces west";
}

TEST(Viewpoint, StaysOutOfVolumesThatHold) {
  ViewpointCase c = on_the_level();
  const double free = best_of(c).utility;
  world::Volume box;
  box.name = "box";
  box.polygon = {{400, 400}, {600, 400}, {600, 600}, {400, 600}};
  c.world.volumes = {box};
  EXPECT_LT(best_of(c).utility, free - 0.1);
  c.query.at = MissionTime::seconds(100);
  c.world.volumes[0].when.until = MissionTime::seconds(100);

  EXPECT_EQ(best_of(c).utility, free) << "it held until then";
  c.world.volumes[0].when = {MissionTime::seconds(500), MissionTime::seconds(600)};
  EXPECT_LT(best_of(c).utility, free) << "it will hold later";
}

TEST(Viewpoint, KeepsConstraints) {
  ViewpointCase c = on_the_level();
  c.query.constraints = {{"west of it", [](const Vector3& p) { return p.x() < 450; }},
                         {"south of it", [](const Vector3& p) { return p.y() < 450; }}};

  const ViewPoint best = best_of(c);

  EXPECT_LT(best.position.x(), 450);
  EXPECT_GT(best.position.x(), 440);
  EXPECT_LT(best.position.y(), 450);
}

TEST(Viewpoint, StaysInTheAirspaceAndUnderTheCeiling) {
  ViewpointCase c = on_the_level();
  c.query.nearest = 100;
  c.query.vehicle.ceiling = 40;
  EXPECT_LE(best_of(c).position.z(), 40);
  c.world.airspace.size = {100, 50, 60};

  EXPECT_LE(best_of(c).position.y(), 500);
}

TEST(Viewpoint, ATargetMayStandOverTheGroundOrBeALittleUnderIt) {
  ViewpointCase c = on_the_level();
  c.query.target.z() = 30;
  EXPECT_GE(best_of(c).quality, 0.99);
  c.query.target.z() = -0.4;

  EXPECT_GE(best_of(c).quality, 0.99);
}

TEST(Viewpoint, SeveralGoAroundTheTargetWhenAnglesAreAsked) {
  ViewpointCase c = on_the_level();
  c.query.count = 3;
  c.query.least_angle = 2 * std::numbers::pi / 3;
  c.query.nearest = 80;
  c.query.vehicle.ceiling = 60;

  const auto found = solve(c);

  ASSERT_TRUE(found);
  ASSERT_EQ(found->task.points.size(), 3u) << "exactly a third of a turn each";
  for (const ViewPoint& point : found->task.points)
    EXPECT_NEAR(point.utility, found->task.points[0].utility, 0.01);
}

TEST(Viewpoint, RoomForMoreIsFoundWhereTheBestOfAllWouldTakeIt) {
  ViewpointCase c = on_the_level();
  c.query.count = 2;
  c.query.least_angle = 1.5;
  c.query.nearest = 80;
  c.query.vehicle.ceiling = 60;
  c.query.from = Vector3(700, 500, 40);
  c.query.cost_of_way = 1e-4;
  // A fan of 1.6 rad, in whose middle is the best: beside it no other is 1.5 rad away.
  c.query.constraints = {{"east", [](const Vector3& p) {
                            return std::abs(std::atan2(p.y() - 500, p.x() - 500)) <= 0.8;
                          }}};

  const auto found = solve(c);

  ASSERT_TRUE(found);
  ASSERT_EQ(found->task.points.size(), 2u);
  EXPECT_GE(std::abs(world::wrapped(found->task.points[0].heading - found->task.points[1].heading)),
            1.5 - 1e-9);
}

TEST(Viewpoint, ThereAreFewerWhenThereIsNoRoom) {
  ViewpointCase c = on_the_level();
  c.query.count = 5;
  c.query.least_angle = 2;
  c.query.nearest = 80;
  c.query.vehicle.ceiling = 60;

  const auto found = solve(c);

  ASSERT_TRUE(found);
  EXPECT_EQ(found->task.points.size(), 3u);
}

TEST(Viewpoint, WithoutAnglesSeveralAreStillDifferentPlaces) {
  ViewpointCase c = on_the_level();
  c.query.count = 6;

  const auto found = solve(c);

  ASSERT_TRUE(found);
  ASSERT_EQ(found->task.points.size(), 6u);
  for (std::size_t i = 1; i < 6; ++i)
    EXPECT_GE((found->task.points[i].position - found->task.points[0].position).norm(),
              250 * kLeastApart * (1 - 1e-6));
}

TEST(Viewpoint, TheSameQueryHasTheSameAnswer) {
  const ViewpointCase c = behind_a_hill();

  const auto once = solve(c), again = solve(c);

  EXPECT_EQ(once->task.points[0].position, again->task.points[0].position);
  EXPECT_EQ(once->effort, again->effort);
  EXPECT_EQ(once->task.sight_checks, again->task.sight_checks);
}

TEST(Viewpoint, KeepsItsBudgetOfSteps) {
  ViewpointCase c = behind_a_hill();
  c.query.count = 8;
  c.query.least_angle = 0.7;
  const auto unbounded = solve(c);
  ASSERT_TRUE(unbounded);
  Budget budget;
  budget.steps = unbounded->effort.steps / 2;

  const auto found = solve(c, budget);

  ASSERT_TRUE(found);
  EXPECT_LE(found->effort.steps, budget.steps + 1);
  EXPECT_FALSE(found->effort.cut_short) << "it ends at the same place everywhere";
  EXPECT_LT(found->task.points.size(), unbounded->task.points.size());
}

TEST(Viewpoint, KeepsItsBudgetOfTime) {
  ViewpointCase c = behind_a_hill();
  c.query.count = 8;
  c.query.least_angle = 0.7;
  Budget budget;
  int asked = 0;
  budget.time_is_up = [&] { return ++asked > 3; };

  const auto found = solve(c, budget);

  ASSERT_TRUE(found);
  EXPECT_TRUE(found->effort.cut_short);
  EXPECT_EQ(asked, 4);
}

TEST(Viewpoint, ABudgetThatEndsBeforeAnythingIsFoundIsARefusal) {
  ViewpointCase c = on_the_level();
  c.query.constraints = {{"nowhere", [](const Vector3&) { return false; }}};
  Budget budget;
  budget.steps = 100;

  const auto found = solve(c, budget);

  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, RefusalKind::kBudgetExhausted);
  EXPECT_THAT(found.error().why, HasSubstr("101"));
}

TEST(Viewpoint, AnUnknownSensorIsRefusedWithTheNearest) {
  ViewpointCase c = on_the_level();
  c.query.device = "visibel";

  const Refusal refusal = refusal_of(c);

  EXPECT_EQ(refusal.kind, RefusalKind::kBeyondVehicle);
  EXPECT_EQ(refusal.field, "device");
  EXPECT_THAT(refusal.why, HasSubstr("did you mean 'visible'?"));
}

TEST(Viewpoint, ASensorThatCannotSeeThatFarIsRefused) {
  ViewpointCase c = on_the_level();
  c.query.nearest = 300;

  EXPECT_EQ(refusal_of(c), (Refusal{RefusalKind::kNotPerceivable, "nearest",
                                    "'visible' perceives nothing from 300 m: its range is 250 m"}));
}

TEST(Viewpoint, ATargetInTheGroundOrOffTheMapIsRefused) {
  ViewpointCase c = on_the_level();
  c.query.target.z() = -12;
  EXPECT_EQ(refusal_of(c),
            (Refusal{RefusalKind::kBlocked, "target", "it is 12 m under the ground"}));
  c.query.target = {-1, 500, 0};

  EXPECT_EQ(refusal_of(c), (Refusal{RefusalKind::kBlocked, "target", "it is outside the terrain"}));
}

TEST(Viewpoint, AClearanceOverTheCeilingIsRefused) {
  ViewpointCase c = on_the_level();
  c.query.clearance = 200;

  EXPECT_EQ(refusal_of(c).kind, RefusalKind::kBeyondVehicle);
  EXPECT_EQ(refusal_of(c).field, "clearance");
}

TEST(Viewpoint, FiguresThatMakeNoSenseAreRefusedByField) {
  using Change = void (*)(ViewpointCase&);
  const std::pair<const char*, Change> changes[] = {
      {"target", [](ViewpointCase& c) { c.query.target.x() = kNaN; }},
      {"from", [](ViewpointCase& c) { c.query.from = Vector3(0, kNaN, 0); }},
      {"nearest", [](ViewpointCase& c) { c.query.nearest = -1; }},
      {"nearest", [](ViewpointCase& c) { c.query.nearest = kNaN; }},
      {"nearest", [](ViewpointCase& c) { c.query.nearest = 90, c.query.farthest = 80; }},
      {"farthest", [](ViewpointCase& c) { c.query.farthest = kNaN; }},
      {"clearance", [](ViewpointCase& c) { c.query.clearance = -5; }},
      {"least_angle", [](ViewpointCase& c) { c.query.least_angle = 4; }},
      {"cost_of_way", [](ViewpointCase& c) { c.query.cost_of_way = -1; }},
      {"count", [](ViewpointCase& c) { c.query.count = 0; }},
      {"count", [](ViewpointCase& c) { c.query.count = 65; }},
      {"constraints",
       [](ViewpointCase& c) {
         c.query.constraints = {{"empty", {}}};
       }},
      {"vehicle.speed.cruise", [](ViewpointCase& c) { c.query.vehicle.cruise_speed = 0; }},
      {"vehicle.sensors.visible.range",
       [](ViewpointCase& c) { c.query.vehicle.sensors[0].range = -1; }},
      {"vehicle.sensors.visible.aperture",
       [](ViewpointCase& c) { c.query.vehicle.sensors[0].aperture = kNaN; }},
      {"vehicle.sensors.visible.quality.at_range",
       [](ViewpointCase& c) { c.query.vehicle.sensors[0].quality.at_range = 2; }},
  };
  for (const auto& [field, change] : changes) {
    ViewpointCase c = on_the_level();
    change(c);

    const Refusal refusal = refusal_of(c);

    EXPECT_EQ(refusal.kind, RefusalKind::kBadQuery) << field;
    EXPECT_EQ(refusal.field, field);
    EXPECT_NE(refusal.why, "");
  }
}

TEST(Viewpoint, WhenNothingWillDoItSaysWhatBecameOfThePlaces) {
  ViewpointCase c = behind_a_hill();
  c.query.constraints = {{"east of the wall", [](const Vector3& p) { return p.x() > 620; }}};
  c.query.vehicle.ceiling = 40;
  world::Volume box;
  box.name = "tower";
  box.polygon = {{600, 600}, {800, 600}, {800, 800}, {600, 800}};
  c.world.volumes = {box};

  const Refusal refusal = refusal_of(c);

  EXPECT_EQ(refusal.kind, RefusalKind::kNotPerceivable);
  EXPECT_EQ(refusal.field, "target");
  for (const char* fact :
       {"hidden by the ground", "under the clearance", "over the vehicle's ceiling",
        "in volume 'tower'", "against constraint 'east of the wall'"})
    EXPECT_THAT(refusal.why, HasSubstr(fact));
}

TEST(Viewpoint, ASensorThatLooksUpPerceivesNothingOfLevelGround) {
  ViewpointCase c = on_the_level();
  c.query.vehicle.sensors[0].gimballed = false;
  c.query.vehicle.sensors[0].boresight_pitch = 0.6;

  const Refusal refusal = refusal_of(c);

  EXPECT_EQ(refusal.kind, RefusalKind::kNotPerceivable);
  EXPECT_THAT(refusal.why, HasSubstr("where its quality is nil"));
}

TEST(Viewpoint, AVehicleThatCannotHoverIsGivenPlacesToPassThrough) {
  ViewpointCase c = on_the_level();
  c.query.vehicle.hovers = false;
  c.query.vehicle.min_speed = 2;
  c.query.vehicle.min_turn_radius = 25;
  c.query.vehicle.orbit_radius = 40;

  EXPECT_GE(best_of(c).quality, 0.99);
}

}  // namespace
}  // namespace skein::refiners
