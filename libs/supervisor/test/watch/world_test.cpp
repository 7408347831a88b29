// SPDX-License-Identifier: Apache-2.0
// The world as believed: places, ground and wind that are told or felt. Source: spec 4.1, 6.2 (6).
#include <cmath>

#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using world::Vector3;

Config config_with_places() {
  Config config = config_for_tests();
  auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
  knowledge->vocabulary.tasks["visit"] = {"visit", {mission::ParameterKind::kPlace}, {}};
  config.knowledge = knowledge;
  auto world = std::make_shared<world::World>(*config.world);
  world->ground.grid = {0, 0, 10, 4, 4};
  config.world = world;
  return config;
}

mission::UnitMission visit(std::uint64_t id, std::uint64_t goal, const std::string& place) {
  mission::UnitMission mission = a_mission(id, {});
  mission.tasks.push_back({GoalId{goal}, "visit", {place}, {}});
  return mission;
}

WorldChanged place_at(const std::string& name, Vector3 at) {
  WorldChanged input;
  input.change.place = {name, std::move(at), 0, std::nullopt};
  return input;
}

const world::World& world_of(const Desk& desk) { return *desk.insertion().base.world; }

/// Goal 701 is about alarm:1 and under way, 702 likewise and planned.
Desk visiting() {
  Desk desk = Desk::engaged(config_with_places());
  desk.give(place_at("alarm:1", {100, 0, 0}));
  mission::UnitMission mission = visit(1, 701, "alarm:1");
  mission.tasks.push_back({GoalId{702}, "visit", {std::string("alarm:1")}, {}});
  desk.add(mission);
  desk.finish(inserted({701, 702}, {TaskOf(100, "goto", 701).takes(100, 110),
                                    TaskOf(101, "goto", 702).after(100).takes(100, 110)}));
  desk.flies();
  desk.runs(100);
  return desk;
}

// ---- places ----

TEST(SupervisorWorld, AMissionMayNameAPlaceOnceItIsKnown) {
  Desk desk = Desk::engaged(config_with_places());
  desk.add(visit(1, 701, "alarm:1"));
  EXPECT_THAT(desk.of<Answer>().at(0).reasons, ElementsAre(HasSubstr("alarm:1")));

  desk.give(place_at("alarm:1", {1, 2, 3}));
  desk.add(visit(2, 702, "alarm:1"));

  EXPECT_TRUE(desk.of<Answer>().at(0).accepted);
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(world_of(desk).places.at("alarm:1"), Vector3(1, 2, 3));
}

TEST(SupervisorWorld, WhatMakesNoSenseOfAPlaceIsRefused) {
  Desk desk = Desk::engaged(config_with_places());

  desk.give(place_at("", {std::nan(""), 0, 0}));

  EXPECT_FALSE(desk.of<Answer>().at(0).accepted);
  EXPECT_THAT(desk.of<Answer>().at(0).reasons, ::testing::SizeIs(2));
}

TEST(SupervisorWorld, APlaceThatMovesALittleChangesNothing) {
  Desk desk = visiting();

  desk.at(10).give(place_at("alarm:1", {103, 0, 0}));

  EXPECT_FALSE(desk.job_started());
  EXPECT_THAT(desk.requests(), IsEmpty());
}

TEST(SupervisorWorld, APlaceThatMovesSomeMakesPlansAboutItAgainButNotWhatIsUnderWay) {
  Desk desk = visiting();

  desk.at(10).give(place_at("alarm:1", {110, 0, 0}));

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().failed->id, GoalId{702});
  EXPECT_THAT(desk.requests(), IsEmpty());
}

TEST(SupervisorWorld, APlaceThatMovesFarStopsWhatGoesThere) {
  Desk desk = visiting();

  desk.at(10).give(place_at("alarm:1", {160, 0, 0}));

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().failed->id, GoalId{701});
  EXPECT_THAT(desk.requests(), Contains("ABORT 100"));
  EXPECT_EQ(desk.repair().base.world->places.at("alarm:1"), Vector3(160, 0, 0));
}

TEST(SupervisorWorld, OtherPlacesDoNotMatter) {
  Desk desk = visiting();
  desk.give(place_at("alarm:2", {0, 0, 0}));

  desk.at(10).give(place_at("alarm:2", {900, 0, 0}));

  EXPECT_FALSE(desk.job_started());
}

// Found by random missions (--escorts): what was agreed on was left at each word of its driver.
TEST(SupervisorWorld, APlaceThatMovesIsForTheRolesOfAJointTaskToSeeTo) {
  Desk desk = Desk::engaged(config_with_places());
  desk.give(place_at("alarm:1", {100, 0, 0}));
  desk.add(visit(1, 701, "alarm:1"));
  desk.finish(inserted({701}, {TaskOf(100, "joint:track", 701)}));

  desk.at(10).give(place_at("alarm:1", {160, 0, 0}));

  EXPECT_FALSE(desk.job_started());
  EXPECT_THAT(desk.requests(), IsEmpty());
}

// ---- places behind a crest ----

// Found by missions over mountains (--fires --rough 7): a third of a fire's monitoring saw the
// crest before it.
class LookOverACrest : public ::testing::Test {
 protected:
  /// From 60 m over the foot of a hill at 200 m, 70 m high, at what is on its top.
  static Desk looking() {
    Config config = config_with_places();
    auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
    world::SensorModel camera;
    camera.device = "visible";
    camera.aperture = 0.5;
    camera.range = 400;
    camera.gimballed = true;
    knowledge->vehicle.sensors = {camera};
    config.knowledge = knowledge;
    auto world = std::make_shared<world::World>(*config.world);
    world::TerrainSpec hill;
    hill.west = hill.south = -400;
    hill.east = hill.north = 400;
    hill.cell = 5;
    hill.hills.push_back({{200, 0}, 70, 60});
    world->terrain = world::Terrain(hill);
    config.world = world;
    Desk desk = Desk::engaged(config);
    desk.give(place_at("alarm:1", kTop));
    desk.add(visit(1, 701, "alarm:1"));
    desk.finish(inserted(
        {701}, {TaskOf(100, "takeshot", 701).takes(100, 110).device("visible").target(kTop)}));
    desk.flies({0, 0, 60});
    desk.runs(100);
    return desk;
  }
  static inline const Vector3 kTop{200, 0, 70};
};

TEST_F(LookOverACrest, GoesOnWhileItsPlaceIsInSight) {
  Desk desk = looking();
  const Vector3 lower{204, 0, 69};
  EXPECT_FALSE(desk.supervisor.loses_sight_of("alarm:1", lower));

  desk.at(10).give(place_at("alarm:1", lower));
  EXPECT_FALSE(desk.job_started());
}

TEST_F(LookOverACrest, IsPlannedAnewOnceTheGroundHidesIt) {
  Desk desk = looking();
  const Vector3 behind{208, 0, 67};
  EXPECT_TRUE(desk.supervisor.loses_sight_of("alarm:1", behind));
  EXPECT_FALSE(desk.supervisor.loses_sight_of("alarm:2", behind));

  desk.at(10).give(place_at("alarm:1", behind));
  ASSERT_TRUE(desk.job_started());
  EXPECT_THAT(desk.requests(), Contains("ABORT 100"));
  EXPECT_FALSE(desk.supervisor.loses_sight_of("alarm:1", {212, 0, 64})) << "it looks no more";
}

// ---- ground ----

TEST(SupervisorWorld, RiskMappedAndBurningGroundIsPlannedWith) {
  Desk desk = Desk::engaged(config_with_places());
  WorldChanged risky, burning;
  risky.change.ground = {"A", {{0, 0}, {40, 0}, {40, 10}, {0, 10}}, 0.9, true, std::nullopt};
  burning.change.place = {"alarm:1", {15, 15, 0}, 0, world::CellState::kFire};

  desk.give(risky);
  desk.give(burning);
  desk.add(a_mission(1, {701}));

  ASSERT_TRUE(desk.job_started());
  const world::GroundState& ground = world_of(desk).ground;
  EXPECT_EQ(ground.risk_at({5, 5}), 0.9);
  EXPECT_EQ(ground.risk_at({5, 25}), 0.5);
  EXPECT_TRUE(ground.mapped.at(0));
  EXPECT_FALSE(ground.mapped.at(4));
  EXPECT_EQ(ground.risk_at({15, 15}), 0) << "what burns is no risk any more";
  EXPECT_EQ(ground.state.at(5), world::CellState::kFire);
}

// ---- wind ----

TEST(SupervisorWorld, TheWindThatIsFeltIsPlannedWithOnceItIsKnown) {
  Config config = config_with_places();
  auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
  knowledge->vehicle.hovers = false;
  knowledge->vehicle.cruise_speed = 8;
  knowledge->vehicle.wind_drift = 1;
  config.knowledge = knowledge;
  Desk desk = Desk::engaged(config);
  std::vector<std::string> said;
  for (int s = 0; s < 200; ++s) {
    world::VehicleState state;
    state.airborne = true;
    state.heading = world::wrapped(0.1 * s);
    state.velocity = 8 * Vector3(std::cos(0.1 * s), std::sin(0.1 * s), 0) + Vector3(3, 0, 0);
    desk.at(s).give(VehicleSeen{state, {}});
    for (const std::string& text : desk.notices())
      if (text.find("wind") != std::string::npos) said.push_back(text);
  }

  desk.add(a_mission(1, {701}));

  EXPECT_THAT(said, ::testing::SizeIs(::testing::AllOf(::testing::Ge(1U), ::testing::Le(4U))));
  ASSERT_TRUE(desk.job_started());
  EXPECT_NEAR(world::mean_velocity(world_of(desk).wind).x(), 3, 0.8);
}

}  // namespace
}  // namespace skein::supervisor
