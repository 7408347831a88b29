// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/missions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <limits>

#include "testing/generators.hpp"

namespace skein::translation {
namespace {

using mission::GoalId;
using mission::MissionId;
using wire::Violation;

mission::UnitMission a_mission() {
  mission::UnitMission mission;
  mission.id = MissionId(7);
  mission.tasks = {{GoalId(701), "perform-detection", {std::string("Z2"), 300.0}, {}},
                   {GoalId(702), "goto", {world::Vector3(1, 2, 3)}, {}}};
  return mission;
}

mission::ChangeWorld a_volume() {
  mission::ChangeWorld change;
  change.volume.name = "smoke";
  change.volume.polygon = {{0, 0}, {10, 0}, {10, 10}};
  return change;
}

// ---- enumerations: both sides mean the same by every name ----

class EveryPlacement : public ::testing::TestWithParam<mission::Placement> {};

TEST_P(EveryPlacement, KeepsItsNameOnTheWire) {
  mission::UnitMission mission = a_mission();
  mission.placement = GetParam();

  EXPECT_EQ(wire::name_of(to_wire(mission).placement), mission::to_text(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Missions, EveryPlacement,
                         ::testing::Values(mission::Placement::kBest, mission::Placement::kLast,
                                           mission::Placement::kInTime, mission::Placement::kTour,
                                           mission::Placement::kFirst));

// ---- round trips ----

RC_GTEST_PROP(Missions, AUnitMissionComesBackAsItWas, ()) {
  const mission::UnitMission mission = testing::any_unit_mission();

  const auto back = from_wire(to_wire(mission));

  RC_ASSERT(back.has_value());
  RC_ASSERT(std::get<mission::UnitMission>(*back) == mission);
}

RC_GTEST_PROP(Missions, ACancellationComesBackAsItWas, ()) {
  const mission::CancelGoals cancel = testing::any_cancellation();

  const wire::MissionRequest request = to_wire(cancel, "operator");

  RC_ASSERT(request.asked_by == "operator");
  const auto back = from_wire(request);
  RC_ASSERT(back.has_value());
  RC_ASSERT(std::get<mission::CancelGoals>(*back) == cancel);
}

RC_GTEST_PROP(Missions, AChangeOfDegreeComesBackAsItWas, ()) {
  const mission::ChangeDegree change{*rc::gen::inRange(1, 5), testing::any_truth(),
                                     testing::any_truth()};

  const wire::DegreeCommand command = to_wire(change, "operator");

  RC_ASSERT(command.asked_by == "operator");
  RC_ASSERT(from_wire(command) == change);
}

RC_GTEST_PROP(Missions, WhatIsTranslatedKeepsTheRulesOfTheWire, ()) {
  RC_ASSERT(!wire::find_violation(to_wire(testing::any_unit_mission())));
  RC_ASSERT(!wire::find_violation(to_wire(testing::any_cancellation(), "operator")));
}

TEST(Missions, AVolumeComesBackWithItsLevelsAndTimes) {
  mission::ChangeWorld change = a_volume();
  change.volume.floor = 20;
  change.volume.ceiling = 120.5;
  change.volume.when = {MissionTime::seconds(3), MissionTime::seconds(90)};

  EXPECT_EQ(from_wire(to_wire(change)), change);
}

// Numbers of the wire are finite.
TEST(Missions, AVolumeWithoutFloorOrCeilingComesBackWithoutThem) {
  const mission::ChangeWorld change = a_volume();

  const wire::WorldChange sample = to_wire(change);

  EXPECT_EQ(wire::find_violation(sample), std::nullopt);
  EXPECT_EQ(from_wire(sample), change);
}

TEST(Missions, TheEndOfAVolumeNeedsItsNameOnly) {
  mission::ChangeWorld change;
  change.volume.name = "smoke";
  change.remove = true;

  EXPECT_EQ(from_wire(to_wire(change)), change);
}

TEST(Missions, APlaceComesBackWithWhatIsKnownOfTheGroundThere) {
  mission::ChangeWorld change;
  change.place = {"alarm:2", {1, 2, 3}, 12.5, world::CellState::kFire};

  EXPECT_EQ(from_wire(to_wire(change)), change);
  change.place->cells.reset();
  EXPECT_EQ(from_wire(to_wire(change)), change);
}

TEST(Missions, GroundComesBackWithWhatIsKnownOfIt) {
  mission::ChangeWorld change;
  change.ground = {"A", {{0, 0}, {9, 0}, {9, 9}}, 0.25, true, std::nullopt};

  EXPECT_EQ(from_wire(to_wire(change)), change);
  change.ground->risk.reset();
  change.ground->cells = world::CellState::kQuiet;
  EXPECT_EQ(from_wire(to_wire(change)), change);
}

TEST(Missions, GroundWithoutCornersOrOfRiskAboveOneIsRefused) {
  mission::ChangeWorld change;
  change.ground = {"A", {{0, 0}, {9, 0}, {9, 9}}, 0.25, true, std::nullopt};
  wire::WorldChange risky = to_wire(change), shapeless = to_wire(change);
  risky.risk = 2;
  shapeless.corners.clear();

  EXPECT_EQ(from_wire(risky).error().field, "risk");
  EXPECT_EQ(from_wire(shapeless).error().field, "corners");
}

TEST(Missions, AnAlarmThatAgesIsOfWhenItWasSeen) {
  wire::Alarm alarm;
  alarm.id = 1;

  EXPECT_EQ(change_of(alarm).place->seen, std::nullopt);
  alarm.seen = MissionTime::seconds(42).count();
  EXPECT_EQ(change_of(alarm).place->seen, MissionTime::seconds(42));
}

TEST(Missions, ASeenObjectIsAPlaceOfWhenItWasSeen) {
  wire::SeenObject object;
  object.name = "fire-front";
  object.at = {85, 40, 1};
  object.spread = 2;
  object.seen = MissionTime::seconds(42).count();

  const mission::ChangeWorld change = change_of(object);

  ASSERT_TRUE(change.place);
  EXPECT_EQ(
      *change.place,
      (mission::KnownPlace{"fire-front", {85, 40, 1}, 2, std::nullopt, MissionTime::seconds(42)}));
}

TEST(Missions, AnAlarmIsAPlaceOfItsNumber) {
  wire::Alarm alarm;
  alarm.id = 7;
  alarm.state = wire::AlarmState::kConfirmed;
  alarm.position = {1, 2, 3};
  alarm.radius = 4;

  const mission::ChangeWorld change = change_of(alarm);

  ASSERT_TRUE(change.place);
  EXPECT_EQ(*change.place, (mission::KnownPlace{"alarm:7", {1, 2, 3}, 4, world::CellState::kFire}));
}

// ---- rubbish ----

struct BadMission {
  std::string name;
  std::function<void(wire::MissionRequest&)> spoil;
  Violation violation;
};

class RubbishMission : public ::testing::TestWithParam<BadMission> {};

TEST_P(RubbishMission, IsRefusedWithTheFieldAndWhy) {
  wire::MissionRequest request = to_wire(a_mission());
  GetParam().spoil(request);

  const auto read = from_wire(request);

  ASSERT_FALSE(read);
  EXPECT_EQ(read.error(), GetParam().violation);
}

INSTANTIATE_TEST_SUITE_P(
    Missions, RubbishMission,
    ::testing::Values(BadMission{"no_id",
                                 [](auto& r) { r.unit_mission = 0; },
                                 {"unit_mission", "0 is not an id"}},
                      BadMission{"goal_without_id",
                                 [](auto& r) { r.tasks[1].id = 0; },
                                 {"tasks[1].id", "0 is not an id"}},
                      BadMission{"goals_of_a_new_mission",
                                 [](auto& r) { r.goals = {3}; },
                                 {"goals", "are for cancelling"}},
                      BadMission{"unknown_kind",
                                 [](auto& r) { r.tasks[0].arguments[0].name = "colour"; },
                                 {"tasks[0].arguments[0]", "'colour' is not a kind of argument"}},
                      BadMission{"number_without_number",
                                 [](auto& r) { r.tasks[0].arguments[1].numbers.clear(); },
                                 {"tasks[0].arguments[1]", "a number has 1 number"}},
                      BadMission{"flat_location",
                                 [](auto& r) {
                                   r.tasks[1].arguments[0].numbers = {1, 2};
                                 },
                                 {"tasks[1].arguments[0]", "a location has 3 numbers"}},
                      BadMission{"tasks_to_cancel",
                                 [](auto& r) { r.cancel = true; },
                                 {"tasks", "what is cancelled is named by goals"}},
                      BadMission{"goal_zero_to_cancel",
                                 [](auto& r) {
                                   r.cancel = true;
                                   r.tasks.clear();
                                   r.goals = {701, 0};
                                 },
                                 {"goals[1]", "0 is not an id"}}),
    [](const auto& one) { return one.param.name; });

class RubbishDegree : public ::testing::TestWithParam<int> {};

TEST_P(RubbishDegree, IsRefused) {
  wire::DegreeCommand command;
  command.degree = static_cast<std::uint8_t>(GetParam());

  const auto read = from_wire(command);

  ASSERT_FALSE(read);
  EXPECT_EQ(to_text(read.error()),
            "degree: " + std::to_string(GetParam()) + " is not a degree from 1 to 5");
}

INSTANTIATE_TEST_SUITE_P(Missions, RubbishDegree, ::testing::Values(0, 6, 9, 255));

struct BadVolume {
  std::string name;
  std::function<void(wire::WorldChange&)> spoil;
  std::string field;
};

class RubbishVolume : public ::testing::TestWithParam<BadVolume> {};

TEST_P(RubbishVolume, IsRefusedWithTheFieldAndWhy) {
  wire::WorldChange change = to_wire(a_volume());
  GetParam().spoil(change);

  const auto read = from_wire(change);

  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, GetParam().field);
  EXPECT_FALSE(read.error().why.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Missions, RubbishVolume,
    ::testing::Values(BadVolume{"no_name", [](auto& c) { c.name.clear(); }, "name"},
                      BadVolume{"half_a_corner", [](auto& c) { c.corners.pop_back(); }, "corners"},
                      BadVolume{"no_corners", [](auto& c) { c.corners.clear(); }, "corners"},
                      BadVolume{"two_corners",
                                [](auto& c) {
                                  c.corners = {0, 0, 1, 1};
                                },
                                "corners"},
                      BadVolume{"no_area", [](auto& c) { c.corners = {0, 0, 1, 1, 2, 2}; },
                                "corners"},
                      BadVolume{"crosses_itself",
                                [](auto& c) { c.corners = {0, 0, 1, 1, 1, 0, 0, 1}; }, "corners"},
                      BadVolume{"no_height", [](auto& c) { c.ceiling = c.floor; }, "ceiling"},
                      BadVolume{"no_time", [](auto& c) { c.until = c.from; }, "until"}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace skein::translation
