// SPDX-License-Identifier: Apache-2.0
#include "skein/deliberation_setup/knowledge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/scenario_setup/overrides.hpp"

namespace skein::deliberation_setup {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string comets_file() {
  return std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/confirmed.yaml";
}

scenario::Scenario comets() {
  auto scenario = scenario::read_scenario(comets_file());
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

// COMETS with a planning domain of this text.
scenario::Scenario planning_with(const std::string& domain) {
  scenario::Scenario scenario = comets();
  scenario.planning.emplace();
  scenario.planning->domain_path = "domains/own.lisp";
  scenario.planning->domain = domain;
  return scenario;
}

constexpr const char* kOneTask =
    "(defdomain own (\n"
    "  (:- (high-level-task survey (zone duration) (detection)) ())\n"
    "  (:- (device-serves fire-sensor detection) ())\n"
    "  (:method (survey ?_zone ?_duration ?_times ?_origin) () ())))\n";

TEST(Knowledge, TheWorldHasWhatTheScenarioSays) {
  scenario::Scenario scenario = planning_with(kOneTask);
  scenario.planning->voxel = 20;
  scenario.planning->ceiling = 300;
  scenario.planning->ground.risk = 0.25;
  world::Volume volume;
  volume.name = "tower";
  scenario.world.volumes = {volume};

  const auto world = world_of(scenario);

  ASSERT_TRUE(world.has_value()) << to_text(world.error());
  EXPECT_EQ(world->airspace.voxel, 20);
  EXPECT_LE(world->airspace.origin.z() + 20 * world->airspace.size[2], 320);
  EXPECT_EQ(world->volumes.at(0).name, "tower");
  EXPECT_EQ(world->ground.risk.at(0), 0.25);
  EXPECT_EQ(world->zones.at(0).name, "Z");
  EXPECT_EQ(world->places.at("aside"), world::Vector3(420, 120, 0));
  EXPECT_EQ(world->radio.range, 2500);
  EXPECT_EQ(world->wind.speed, 2);
  EXPECT_EQ(world->terrain.spec().hills.size(), 3U);
}

TEST(Knowledge, OfAUavIsWhatItIsAndWhoItsTeamIs) {
  scenario::Scenario scenario = planning_with(kOneTask);
  scenario.planning->altitude = 55;

  const CommonKnowledge common(scenario);
  const supervisor::Knowledge knowledge = *common.of("heliv");

  EXPECT_EQ(knowledge.uav, "heliv");
  EXPECT_EQ(knowledge.vehicle.name, "heliv");
  EXPECT_EQ(knowledge.home.x(), -40);
  EXPECT_EQ(knowledge.home.y(), 30);
  EXPECT_EQ(knowledge.home.z(), world::Terrain(scenario.world.terrain).elevation(-40, 30));
  EXPECT_EQ(knowledge.altitude, 55);
  EXPECT_THAT(knowledge.team, ElementsAre("marvin", "heliv", "karma"));
  ASSERT_EQ(knowledge.partners.size(), 3U);
  EXPECT_EQ(knowledge.partners[2].uav, "karma");
  EXPECT_EQ(knowledge.partners[2].vehicle.name, "karma");
  EXPECT_EQ(knowledge.partners[2].home.x(), scenario.uavs[2].start.x());
  EXPECT_EQ(knowledge.partners[2].altitude, 55);
  EXPECT_EQ(knowledge.domain.file, "domains/own.lisp");
  ASSERT_EQ(knowledge.vocabulary.tasks.size(), 1U);
  EXPECT_EQ(knowledge.vocabulary.tasks.begin()->first, "survey");
}

TEST(Knowledge, OfOthersIsOneListForAll) {
  const CommonKnowledge common(planning_with(kOneTask));

  const auto marvin = common.of("marvin"), heliv = common.of("heliv");

  EXPECT_TRUE(marvin->partners.shares(heliv->partners));
  EXPECT_TRUE(marvin->team.shares(heliv->team));
}

TEST(Knowledge, EveryErrorOfTheDomainIsToldWithItsFileAndLine) {
  const scenario::Scenario scenario = planning_with(
      "(defdomain own (\n"
      "  (:- (high-level-task survey (zoen) ()) ())\n"
      "  (:- (high-level-task watch (duraton) ()) ())\n"
      "  (:method (survey ?_zone ?_times ?_origin) () ())\n"
      "  (:method (watch ?_duration ?_times ?_origin) () ())))\n");

  const Diagnostics diagnostics = planning_problems(scenario);

  ASSERT_EQ(diagnostics.size(), 2U) << to_text(diagnostics);
  EXPECT_THAT(to_text(diagnostics), HasSubstr("domains/own.lisp:2"));
  EXPECT_THAT(to_text(diagnostics), HasSubstr("domains/own.lisp:3"));
}

TEST(Knowledge, ADomainThatIsNoneIsRefused) {
  EXPECT_FALSE(planning_problems(planning_with("(defdomain own (")).empty());
  EXPECT_FALSE(planning_problems(planning_with("")).empty());
}

TEST(Knowledge, AnAirspaceThatIsNoneIsRefused) {
  scenario::Scenario scenario = planning_with(kOneTask);
  scenario.planning->ceiling = -500;

  EXPECT_THAT(to_text(planning_problems(scenario)),
              HasSubstr("planning: the airspace has no extent"));
}

TEST(Knowledge, DegreeFourNeedsPlanningHoweverItIsAskedFor) {
  scenario_setup::Overrides overrides;
  overrides.degrees = {"4"};

  const auto loaded = scenario_setup::load_scenario(comets_file(), overrides, planning_problems);

  ASSERT_FALSE(loaded.has_value());
  EXPECT_EQ(loaded.error().size(), 3U);
  EXPECT_THAT(to_text(loaded.error()), HasSubstr("degree 4 of karma"));
}

// ---- joint tasks ----

scenario::Scenario reference_example() {
  auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/mref/nominal.yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

std::vector<std::string>& members_of_first_mission(scenario::Scenario& scenario) {
  auto& action = scenario.ground.script.steps.at(0).actions.at(0);
  auto& task = std::get<ground_station::SendMission>(action).mission.tasks.at(1);
  return std::get<std::vector<std::string>>(task.arguments.at(4));
}

TEST(JointTasks, ThoseOfTheReferenceExampleMakeSense) {
  const scenario::Scenario scenario = reference_example();

  ASSERT_NE(scenario.interaction, nullptr);
  EXPECT_TRUE(joint_task_problems(scenario).empty());
}

TEST(JointTasks, MembersThatCannotTakePartAreNamedAllAtOnce) {
  scenario::Scenario scenario = reference_example();
  scenario.uavs.at(1).degree = 3;
  members_of_first_mission(scenario) = {"uav2", "uav3"};

  const std::string problems = to_text(joint_task_problems(scenario));

  EXPECT_THAT(problems,
              HasSubstr("scenarios/mref/nominal.yaml:55: ground.script[0].do[0].mission.tasks[1]: "
                        "monitoring-with-relay of uav1: it is not among the members"));
  EXPECT_THAT(problems, HasSubstr("no UAV 'uav3'"));
  EXPECT_THAT(problems, HasSubstr("uav2 does not deliberate"));
}

TEST(JointTasks, AreForAsManyAsAVariantIsFor) {
  scenario::Scenario scenario = reference_example();
  scenario.uavs.push_back(scenario.uavs.back());
  scenario.uavs.back().name = "uav3";
  members_of_first_mission(scenario) = {"uav1", "uav2", "uav3"};

  EXPECT_THAT(to_text(joint_task_problems(scenario)),
              HasSubstr("monitoring-with-relay of uav1: no variant is for 3 UAVs; expected "
                        "perceive × 1 and relay × 1"));
}

// ---- global missions ----

/// Two UAVs share out one mission of three perceptions: 11, 12 and 13, at 10 s.
scenario::Scenario team_of_two() {
  auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/team/two.yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

team::GlobalMission& mission_of(scenario::Scenario& scenario) {
  for (auto& step : scenario.ground.script.steps) {
    for (auto& action : step.actions) {
      if (auto* sent = std::get_if<ground_station::SendGlobalMission>(&action))
        return sent->mission;
    }
  }
  ADD_FAILURE() << "no global mission";
  static team::GlobalMission none;
  return none;
}

TEST(GlobalMissions, ThoseOfTheTeamScenariosMakeSense) {
  EXPECT_TRUE(global_mission_problems(team_of_two()).empty());
}

TEST(GlobalMissions, ATaskThatWaitsForItselfIsNamedAtItsLine) {
  scenario::Scenario scenario = team_of_two();
  mission_of(scenario).tasks.at(0).after = {mission::GoalId(12)};
  mission_of(scenario).tasks.at(1).after = {mission::GoalId(11)};

  EXPECT_THAT(to_text(global_mission_problems(scenario)),
              ::testing::MatchesRegex(
                  ".*scenarios/team/two.yaml:[0-9]+: ground.script\\[0\\].do\\[0\\]."
                  "global_mission.tasks\\[[01]\\]: global mission 1: tasks 1[12], 1[12], 1[12]: "
                  "each is to end before the next begins; expected tasks that can all be done\n"));
}

TEST(GlobalMissions, TheTimeAtWhichTheyAreGivenCounts) {
  scenario::Scenario scenario = team_of_two();
  mission_of(scenario).tasks.at(0).task.time.end_before = MissionTime::seconds(29);

  EXPECT_THAT(to_text(global_mission_problems(scenario)),
              HasSubstr("global mission 1: task 11: the last cannot end before 30 s, its deadline "
                        "is 29 s: 11 begins at 10 s at the earliest and lasts 20 s"));
}

TEST(GlobalMissions, WhatNobodyHasWhatItNeedsIsNamedWithWhatEachLacks) {
  using interaction::Requirement;
  scenario::Scenario scenario = team_of_two();
  scenario.uavs.at(0).model.abilities = {{"payload", 1}};
  mission_of(scenario).tasks.at(0).needs = {
      {"payload", Requirement::Bound{interaction::Relation::kAtLeast, 2}}};

  EXPECT_THAT(to_text(global_mission_problems(scenario)),
              HasSubstr("global mission 1: task 11: nobody has what it needs: heliv: it lacks "
                        "payload ≥ 2; marvin: it lacks payload ≥ 2 (it has 1)"));
}

TEST(GlobalMissions, ThoseOfOperatorsAreLookedAtToo) {
  scenario::Scenario scenario = team_of_two();
  team::GlobalMission narrow = mission_of(scenario);
  narrow.tasks.resize(1);
  narrow.tasks.at(0).task.time.end_before = MissionTime::seconds(9);
  scenario.ground.script.operators.push_back({"asks",
                                              {ground_station::OnStep{"end"}},
                                              {},
                                              {ground_station::SendGlobalMission{narrow, {}}}});

  EXPECT_THAT(to_text(global_mission_problems(scenario)), HasSubstr("its deadline is 9 s"));
}

}  // namespace
}  // namespace skein::deliberation_setup
