// SPDX-License-Identifier: Apache-2.0
// What becomes of the parts of a right file about planning on board, degrees, closed air,
// variations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "skein/scenario/scenario.hpp"
#include "testing/files.hpp"

namespace skein::scenario {
namespace {

namespace gs = ground_station;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::planning_scenario_with;
using testing::read_valid;
using world::Vector3;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

gs::SendMission mission_with(const std::string& piece, const std::string& instead) {
  const Scenario scenario = read_valid(planning_scenario_with(piece, instead));
  return std::get<gs::SendMission>(scenario.ground.script.steps.at(0).actions.at(0));
}
// The second task of the mission, with what stands after its id instead.
gs::SendMission mission_with_task(const std::string& task) {
  return mission_with("{id: 701, task: [perceive, base, 20]}", "{id: 701, " + task + "}");
}

template <class Action>
Action action_of(const std::string& text) {
  const Scenario scenario =
      read_valid(planning_scenario_with("do: [{finish: true}]", "do: [{" + text + "}]"));
  return std::get<Action>(scenario.ground.script.steps.at(1).actions.at(0));
}

gs::Trigger trigger_of(const std::string& text) {
  return read_valid(planning_scenario_with("when: {goal: {uav: karma, id: 701, state: achieved}}",
                                           "when: " + text))
      .ground.script.steps.at(1)
      .when;
}

Scenario with_top(const std::string& text) {
  return read_valid(planning_scenario_with("expect:", text + "\nexpect:"));
}

// ---- planning ----

TEST(Planning, IsKeptConsistentByTheAlgorithmThatIsNamed) {
  using temporal::Algorithm;
  const auto by = [](const std::string& name) {
    return read_valid(planning_scenario_with("first_ids:", "consistency: " + name + ", first_ids:"))
        .planning->consistency;
  };

  EXPECT_EQ(read_valid(planning_scenario_with()).planning->consistency, Algorithm::kDipM);
  EXPECT_EQ(by("dip-m"), Algorithm::kDipM);
  EXPECT_EQ(by("dip-l"), Algorithm::kDipL);
  EXPECT_EQ(by("dip-g"), Algorithm::kDipG);
  EXPECT_EQ(by("cip"), Algorithm::kCip);
  EXPECT_EQ(by("none"), std::nullopt);
}

TEST(Planning, SaysHowLongASilentPartnerIsWaitedFor) {
  EXPECT_EQ(read_valid(planning_scenario_with()).planning->partner_lease, Duration::seconds(600));
  const Scenario scenario =
      read_valid(planning_scenario_with("first_ids:", "partner_lease: 90, first_ids:"));
  EXPECT_EQ(scenario.planning->partner_lease, Duration::seconds(90));
}

TEST(Planning, SaysHowLongAJobTakesInVirtualTime) {
  const Scenario scenario =
      read_valid(planning_scenario_with("first_ids:", "takes: [0.5, 3], first_ids:"));
  EXPECT_EQ(scenario.planning->takes_least, Duration::seconds(0.5));
  EXPECT_EQ(scenario.planning->takes_most, Duration::seconds(3));
}

TEST(Planning, IsKeptWithTheTextOfItsDomain) {
  const Scenario scenario = read_valid(planning_scenario_with());

  ASSERT_TRUE(scenario.planning);
  EXPECT_EQ(scenario.planning->domain_file, "../domains/comets.lisp");
  EXPECT_THAT(scenario.planning->domain_path, HasSubstr("scenarios/comets/../domains/comets.lisp"));
  EXPECT_THAT(scenario.planning->domain, HasSubstr("(defdomain "));
  EXPECT_EQ(scenario.planning->first_ids.at("karma"), executive::TaskId(100));
  EXPECT_EQ(scenario.find_uav("karma")->degree, 4);
}

// Found by missions of an outsider: task 2 of the script was taken for task 2 of the plan, which
// was over, and what waited for it to run was given up.
TEST(Planning, TasksOfAPlanAreNumberedBeyondThoseOfTheScript) {
  const auto first_of_karma = [](const std::string& planning, const std::string& tasks) {
    std::string text = planning_scenario_with("first_ids: {karma: 100}", planning);
    const std::string nothing = "do: [{finish: true}]";
    text.replace(text.find(nothing), nothing.size(),
                 "do: [{plan: {uav: karma, tasks: [" + tasks + "]}}]");
    const auto first_ids = read_valid(text).planning->first_ids;
    return first_ids.contains("karma") ? first_ids.at("karma").value() : 1;
  };

  EXPECT_EQ(first_of_karma("altitude: 40", "{id: 7, type: land}, {id: 3, type: land}"), 8U);
  EXPECT_EQ(first_of_karma("first_ids: {karma: 5}", "{id: 7, type: land}"), 5U) << "as it says";
  EXPECT_EQ(first_of_karma("altitude: 40", "{id: 300000007, type: land}"), 1U) << "far beyond";
}

TEST(Planning, WhatIsLeftOutHasADefault) {
  const PlanningSpec planning = *read_valid(planning_scenario_with()).planning;

  EXPECT_EQ(planning.altitude, 40);
  EXPECT_EQ(planning.voxel, 10);
  EXPECT_EQ(planning.ceiling, std::nullopt);
  EXPECT_EQ(planning.horizon, Duration::seconds(15));
  EXPECT_EQ(std::get<double>(planning.ground.risk), 0.5);
}

TEST(Planning, WhatIsGivenCounts) {
  const PlanningSpec planning =
      *read_valid(planning_scenario_with("first_ids: {karma: 100}",
                                         "altitude: 60, altitudes: {karma: 80}, voxel: 20, "
                                         "ceiling: 400, horizon: 30, risk: {base: 0.1, peaks: "
                                         "[{at: [10, 20], risk: 0.8, radius: 50}]}"))
           .planning;

  EXPECT_EQ(planning.altitude, 60);
  EXPECT_EQ(planning.altitudes.at("karma"), 80);
  EXPECT_EQ(planning.voxel, 20);
  EXPECT_EQ(planning.ceiling, 400);
  EXPECT_EQ(planning.horizon, Duration::seconds(30));
  const auto& peaks = std::get<world::RiskPeaks>(planning.ground.risk);
  EXPECT_EQ(peaks.base, 0.1);
  ASSERT_EQ(peaks.peaks.size(), 1U);
  EXPECT_EQ(peaks.peaks[0].radius, 50);
}

TEST(Planning, AScenarioNeedNotSayAnythingOfIt) {
  EXPECT_FALSE(read_valid(testing::scenario_with()).planning);
}

TEST(Planning, ClosedAirIsKept) {
  const Scenario scenario = read_valid(planning_scenario_with(
      "ceiling: 90}",
      "ceiling: 90, floor: 10, from: 20, until: 30}, all: {polygon: [[0, 0], [9, "
      "0], [9, 9]]}"));

  ASSERT_EQ(scenario.world.volumes.size(), 2U);
  EXPECT_EQ(scenario.world.volumes[0].name, "tower");
  EXPECT_EQ(scenario.world.volumes[0].floor, 10);
  EXPECT_EQ(scenario.world.volumes[0].ceiling, 90);
  EXPECT_EQ(scenario.world.volumes[0].when, (world::TimeWindow{at(20), at(30)}));
  EXPECT_EQ(scenario.world.volumes[1].floor, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(scenario.world.volumes[1].when, world::TimeWindow());
}

// ---- missions ----

TEST(Missions, KeepIdsTasksAndDefaults) {
  const gs::SendMission send = mission_with("", "");

  EXPECT_EQ(send.uav, "karma");
  EXPECT_EQ(send.mission.id, mission::MissionId(1));
  ASSERT_EQ(send.mission.tasks.size(), 2U);
  EXPECT_EQ(mission::to_text(send.mission.tasks[0]), "general-takeoff");
  EXPECT_EQ(mission::to_text(send.mission.tasks[1]), "perceive base 20");
  EXPECT_EQ(send.mission.tasks[1].id, mission::GoalId(701));
  EXPECT_EQ(send.mission.placement, mission::Placement::kBest);
  EXPECT_FALSE(send.mission.interrupt);
  EXPECT_THAT(send.targets, IsEmpty());
}

TEST(Missions, ArgumentsAreNamesNumbersPointsOrListsOfNames) {
  const auto arguments = mission_with_task("task: [any, Z, 20.5, [1, 2, 3], [karma, heliv], []]")
                             .mission.tasks[1]
                             .arguments;

  ASSERT_EQ(arguments.size(), 5U);
  EXPECT_EQ(arguments[0], mission::Argument("Z"));
  EXPECT_EQ(arguments[1], mission::Argument(20.5));
  EXPECT_EQ(arguments[2], mission::Argument(Vector3(1, 2, 3)));
  EXPECT_EQ(arguments[3], (mission::Argument(std::vector<std::string>{"karma", "heliv"})));
  EXPECT_EQ(arguments[4], mission::Argument(std::vector<std::string>()));
}

TEST(Missions, ArgumentsMayBeAboutTheAlarm) {
  const gs::SendMission send = mission_with_task(
      "task: [any, 5, alarm, {near_alarm: {bearing: 1, distance: 80, altitude: 40}}]");

  ASSERT_EQ(send.targets.size(), 2U);
  EXPECT_EQ(send.targets[0].task, 1U);
  EXPECT_EQ(send.targets[0].argument, 1U);
  EXPECT_TRUE(std::holds_alternative<gs::TheAlarm>(send.targets[0].where));
  EXPECT_EQ(send.targets[1].argument, 2U);
  EXPECT_EQ(std::get<gs::NearAlarm>(send.targets[1].where).distance, 80);
  EXPECT_EQ(send.mission.tasks[1].arguments.size(), 3U);
}

TEST(Missions, TimeConstraintsAreInstantsOfTheMission) {
  const mission::TimeConstraints some =
      mission_with_task("task: [any], start_after: 10, end_before: 300").mission.tasks[1].time;
  const mission::TimeConstraints others =
      mission_with_task("task: [any], start_before: 20, end_after: 40").mission.tasks[1].time;

  EXPECT_EQ(some, (mission::TimeConstraints{{}, at(10), at(300), {}}));
  EXPECT_EQ(others, (mission::TimeConstraints{at(20), {}, {}, at(40)}));
}

TEST(Missions, BoundsAfterGoalsAreSecondsAfterTheirEnd) {
  const auto start =
      mission_with_task("task: [any], start_after_goal: {goal: 700, least: 10, most: 60}");
  const auto end = mission_with_task("task: [any], end_after_goal: {goal: 700, most: 60.5}");

  ASSERT_EQ(start.mission.tasks[1].after.size(), 1U);
  EXPECT_EQ(start.mission.tasks[1].after[0],
            (mission::GoalBound{mission::GoalId(700), false, Duration::seconds(10),
                                Duration::seconds(60)}));
  EXPECT_EQ(end.mission.tasks[1].after[0],
            (mission::GoalBound{mission::GoalId(700), true, {}, Duration::seconds(60.5)}));
}

TEST(Missions, EveryPlacementIsRead) {
  for (const char* word : {"best", "last", "in-time", "tour", "first"}) {
    const auto send =
        mission_with("id: 1, tasks", "id: 1, placement: " + std::string(word) + ", tasks");

    EXPECT_EQ(mission::to_text(send.mission.placement), word);
  }
  EXPECT_TRUE(mission_with("id: 1, tasks", "id: 1, placement: first, interrupt: true, tasks")
                  .mission.interrupt);
}

TEST(Missions, OfDifferentUavsMayHaveTheSameIds) {
  const auto send = action_of<gs::SendMission>(
      "mission: {uav: heliv, id: 1, tasks: [{id: 700, task: [general-land]}]}");

  EXPECT_EQ(send.uav, "heliv");
}

// What the domain makes of it is not the reader's business: a scenario may test refusals.
TEST(Missions, ThatADomainWillRefuseAreRead) {
  EXPECT_EQ(mission_with_task("task: [fly-to-the-moon, nowhere]").mission.tasks[1].name,
            "fly-to-the-moon");
}

// ---- other actions ----

TEST(PlanningActions, CancelsAreRead) {
  const auto all = action_of<gs::CancelMission>("cancel: {uav: karma, goals: all}");
  const auto some =
      action_of<gs::CancelMission>("cancel: {uav: karma, goals: [700, 701], interrupt: false}");
  const auto mission = action_of<gs::CancelMission>("cancel: {uav: karma, mission: 1}");

  EXPECT_EQ(all.cancel, mission::CancelGoals());
  EXPECT_EQ(some.cancel,
            (mission::CancelGoals{{mission::GoalId(700), mission::GoalId(701)}, {}, false}));
  EXPECT_EQ(mission.cancel, (mission::CancelGoals{{}, mission::MissionId(1), true}));
}

TEST(PlanningActions, ChangesOfDegreeAreRead) {
  const auto plain = action_of<gs::SetDegree>("degree: {uav: karma, to: 3}");
  const auto full =
      action_of<gs::SetDegree>("degree: {uav: karma, to: 4, interrupt: true, resume: false}");

  EXPECT_EQ(plain.change, (mission::ChangeDegree{3, false, true}));
  EXPECT_EQ(full.change, (mission::ChangeDegree{4, true, false}));
}

TEST(PlanningActions, TheHandOfAnOperatorIsRead) {
  EXPECT_FALSE(action_of<gs::TakeInHand>("take_in_hand: {uav: karma}").interrupt);
  EXPECT_TRUE(action_of<gs::TakeInHand>("take_in_hand: {uav: karma, interrupt: true}").interrupt);
  EXPECT_EQ(action_of<gs::GiveBack>("give_back: {uav: karma}").uav, "karma");
  EXPECT_EQ(action_of<gs::DropPlan>("drop_plan: {uav: karma}").uav, "karma");
  EXPECT_THAT(action_of<gs::ResumePlan>("resume_plan: {uav: karma}").without, IsEmpty());
  EXPECT_THAT(action_of<gs::ResumePlan>("resume_plan: {uav: karma, without: [103]}").without,
              ElementsAre(executive::TaskId(103)));
}

TEST(PlanningActions, AirIsClosedAndOpened) {
  const auto close = action_of<gs::CloseAir>(
      "close_air: {name: n, polygon: [[0, 0], [9, 0], [9, 9]], floor: 5, ceiling: 80, uavs: "
      "[karma]}");
  const auto open = action_of<gs::OpenAir>("open_air: {name: tower}");

  EXPECT_EQ(close.volume.name, "n");
  EXPECT_EQ(close.volume.floor, 5);
  EXPECT_EQ(close.volume.ceiling, 80);
  EXPECT_THAT(close.uavs, ElementsAre("karma"));
  EXPECT_EQ(open.name, "tower");
  EXPECT_THAT(open.uavs, IsEmpty());
}

TEST(PlanningActions, PlacesAndGroundAreTold) {
  const auto place = action_of<gs::TellWorld>(
      "know_place: {name: well, at: [1, 2, 3], radius: 4, cells: fire, uavs: [karma]}");
  const auto ground = action_of<gs::TellWorld>(
      "know_ground: {name: A, polygon: [[0, 0], [9, 0], [9, 9]], risk: 0.8, mapped: true}");

  EXPECT_EQ(*place.change.place,
            (mission::KnownPlace{"well", {1, 2, 3}, 4, world::CellState::kFire}));
  EXPECT_THAT(place.uavs, ElementsAre("karma"));
  EXPECT_EQ(ground.change.ground->risk, 0.8);
  EXPECT_TRUE(ground.change.ground->mapped);
  EXPECT_EQ(ground.change.ground->area.size(), 3U);
  EXPECT_FALSE(ground.change.ground->cells);
}

TEST(PlanningTriggers, AreRead) {
  const auto mission =
      std::get<gs::OnMission>(trigger_of("{mission: {uav: karma, id: 1, state: failed}}").what);
  const auto goal =
      std::get<gs::OnGoal>(trigger_of("{goal: {uav: karma, id: 700, state: handed-over}}").what);
  const auto degree = std::get<gs::OnDegree>(trigger_of("{degree: {uav: heliv, is: 1}}").what);

  EXPECT_EQ(mission.mission, mission::MissionId(1));
  EXPECT_EQ(mission.state, gs::MissionStage::kFailed);
  EXPECT_EQ(goal.goal, mission::GoalId(700));
  EXPECT_EQ(goal.state, mission::GoalState::kHandedOver);
  EXPECT_EQ(degree.uav, "heliv");
  EXPECT_EQ(degree.degree, 1);
}

TEST(PlanningTriggers, EveryStateOfAGoalIsRead) {
  for (int i = 0; i < static_cast<int>(mission::GoalState::kCount); ++i) {
    const auto state = static_cast<mission::GoalState>(i);
    const std::string word(mission::to_text(state));

    const auto trigger = trigger_of("{goal: {uav: karma, id: 700, state: " + word + "}}");

    EXPECT_EQ(std::get<gs::OnGoal>(trigger.what).state, state) << word;
  }
}

// ---- faults ----

TEST(PlanningFaults, OfTheFunctionalLayerAreKept) {
  const FaultSpec faults = with_top(
                               "faults:\n  - {at: 5, slow: {uav: karma, factor: 3, for: 60}}\n"
                               "  - {at: 6, abort: {uav: heliv, type: takeshot}}\n"
                               "  - {at: 6, abort: {uav: heliv, type: land, for: 40}}\n"
                               "  - {at: 7, energy: {uav: karma, left: 0.2}}")
                               .faults;

  ASSERT_EQ(faults.slows.size(), 1U);
  EXPECT_EQ(faults.slows[0].uav, "karma");
  EXPECT_EQ(faults.slows[0].factor, 3);
  EXPECT_EQ(faults.slows[0].lasts, Duration::seconds(60));
  ASSERT_EQ(faults.aborts.size(), 2U);
  EXPECT_EQ(faults.aborts[0].type, "takeshot");
  EXPECT_EQ(faults.aborts[0].at, at(6));
  EXPECT_EQ(faults.aborts[0].lasts, Duration());
  EXPECT_EQ(faults.aborts[1].lasts, Duration::seconds(40));
  ASSERT_EQ(faults.energies.size(), 1U);
  EXPECT_EQ(faults.energies[0].left, 0.2);
}

// ---- measures ----

std::vector<ClosedAir> measured_air(const std::string& actions) {
  std::string text = planning_scenario_with("do: [{finish: true}]", "do: [" + actions + "]");
  text += "  - {name: keeps out, measure: time-in-volume, at_most: 0}\n";
  return std::get<ExpectMeasure>(read_valid(text).expectations.back().what).air;
}

TEST(TimeInVolume, IsAboutWhatIsClosedFromTheStartAndByTheScript) {
  const auto air = measured_air(
      "{close_air: {name: n, polygon: [[0, 0], [9, 0], [9, 9]]}}, {open_air: {name: tower}}");

  ASSERT_EQ(air.size(), 2U);
  EXPECT_EQ(air[0].volume.name, "tower");
  EXPECT_FALSE(air[0].closed_by);
  EXPECT_EQ(to_text(air[0].opened_by.value()), "{kind: step, name: end}");
  EXPECT_EQ(air[1].volume.name, "n");
  EXPECT_EQ(to_text(air[1].closed_by.value()), "{kind: step, name: end}");
  EXPECT_FALSE(air[1].opened_by);
}

// ---- variations ----

constexpr const char* kVariations =
    "variations: {wind_speed: [1, 4], wind_toward: [0, 6.28], speed_factor: [0.9, 1.1], latency: "
    "[0.01, 0.3], loss: [0, 0.05], start_delay: [2, 9]}";

Scenario drawn(std::uint64_t seed, const std::string& text = kVariations) {
  Scenario scenario = with_top(text);
  scenario.seed = seed;
  draw_variations(scenario);
  return scenario;
}

std::vector<double> figures_of(const Scenario& s) {
  return {s.world.wind.speed,
          s.world.wind.toward,
          s.uavs[0].speed_factor,
          s.uavs[1].speed_factor,
          s.radio.model.latency.to_seconds(),
          s.radio.model.loss,
          std::get<gs::AtTime>(s.ground.script.steps[0].when.what).at.to_seconds()};
}

TEST(Variations, FollowFromTheSeed) {
  EXPECT_EQ(figures_of(drawn(3)), figures_of(drawn(3)));
  const auto three = figures_of(drawn(3)), four = figures_of(drawn(4));
  for (std::size_t i = 0; i < three.size(); ++i) EXPECT_NE(three[i], four[i]) << i;
}

TEST(Variations, LieWithinTheirBounds) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto figures = figures_of(drawn(seed));
    const std::vector<std::pair<double, double>> bounds{
        {1, 4}, {0, 6.28}, {0.9, 1.1}, {0.9, 1.1}, {0.01, 0.3}, {0, 0.05}, {7, 14}};
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      EXPECT_GE(figures[i], bounds[i].first) << i;
      EXPECT_LE(figures[i], bounds[i].second) << i;
    }
  }
}

TEST(Variations, WithoutThemNothingChanges) {
  Scenario scenario = read_valid(planning_scenario_with());
  const auto before = figures_of(scenario);

  draw_variations(scenario);

  EXPECT_EQ(figures_of(scenario), before);
  EXPECT_EQ(before[2], 1);
}

TEST(Variations, OfOneFigureDoNotChangeTheOthers) {
  const auto all = figures_of(drawn(7));
  const auto some = figures_of(drawn(7, "variations: {loss: [0, 0.05], wind_speed: [1, 4]}"));

  EXPECT_EQ(some[0], all[0]);
  EXPECT_EQ(some[5], all[5]);
}

TEST(Variations, ADelayShiftsEveryInstantOfTheScriptAlike) {
  Scenario scenario = with_top("variations: {start_delay: [3, 3]}");
  scenario.ground.script.steps[1].when = {
      gs::AllOf{{{gs::AtTime{at(10)}}, {gs::AnyOf{{{gs::AtTime{at(20)}}}}}}}};

  draw_variations(scenario);

  const auto& steps = scenario.ground.script.steps;
  EXPECT_EQ(std::get<gs::AtTime>(steps[0].when.what).at, at(8));
  const auto& all = std::get<gs::AllOf>(steps[1].when.what);
  EXPECT_EQ(std::get<gs::AtTime>(all.of[0].what).at, at(13));
  EXPECT_EQ(std::get<gs::AtTime>(std::get<gs::AnyOf>(all.of[1].what).of[0].what).at, at(23));
}

}  // namespace
}  // namespace skein::scenario
