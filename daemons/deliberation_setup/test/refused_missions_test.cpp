// SPDX-License-Identifier: Apache-2.0
#include "skein/deliberation_setup/refused_missions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/scenario/scenario.hpp"

namespace skein::deliberation_setup {
namespace {

using ground_station::SendMission;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

/// Karma at degree 4 is sent one mission.
scenario::Scenario one_mission() {
  auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/karma/detection.yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

mission::HighLevelTask& detection_in(scenario::Scenario& scenario) {
  for (auto& step : scenario.ground.script.steps) {
    for (auto& action : step.actions)
      if (auto* sent = std::get_if<SendMission>(&action)) return sent->mission.tasks.at(2);
  }
  ADD_FAILURE() << "no mission";
  static mission::HighLevelTask none;
  return none;
}

std::string refused(const scenario::Scenario& scenario) {
  return to_text(refused_missions(scenario));
}

TEST(RefusedMissions, OfAMissionThatMakesSenseNothingIsSaid) {
  EXPECT_EQ(refused(one_mission()), "");
}

TEST(RefusedMissions, AMisspeltTaskIsNamedAtItsLineWithTheNearest) {
  scenario::Scenario scenario = one_mission();
  auto& task = detection_in(scenario);
  ASSERT_EQ(task.name, "perform-detection");
  task.name = "perfrom-detection";

  EXPECT_THAT(refused(scenario),
              MatchesRegex(".*scenarios/karma/detection.yaml:[0-9]+: ground.script\\[[0-9]+\\]."
                           "do\\[[0-9]+\\].mission.tasks\\[2\\]: mission 1 to karma will be "
                           "refused: task [0-9]+: unknown task 'perfrom-detection'; did you mean "
                           "'perform-detection'\\?\n"));
}

TEST(RefusedMissions, EveryArgumentIsLookedAt) {
  scenario::Scenario scenario = one_mission();
  detection_in(scenario).arguments = {std::string("Z9"), std::string("P9"), std::string("300 s")};

  EXPECT_THAT(refused(scenario), HasSubstr("argument 1: unknown zone 'Z9'"));
  EXPECT_THAT(refused(scenario), HasSubstr("argument 2: unknown place 'P9'"));
  EXPECT_THAT(refused(scenario), HasSubstr("argument 3 must be a duration"));
}

TEST(RefusedMissions, PlacesThatAreToldMeanwhileAreNotUnknown) {
  scenario::Scenario scenario = one_mission();
  auto& task = detection_in(scenario);
  task.arguments.at(1) = std::string("well");
  ground_station::TellWorld told;
  told.change.place = mission::KnownPlace{"well"};
  scenario.ground.script.steps.at(0).actions.emplace_back(told);
  EXPECT_EQ(refused(scenario), "");

  task.arguments.at(1) = std::string("alarm:1");
  EXPECT_EQ(refused(scenario), "");
}

TEST(RefusedMissions, WhoNeverDeliberatesIsNamed) {
  scenario::Scenario scenario = one_mission();
  scenario.uavs.at(0).degree = 3;
  EXPECT_THAT(refused(scenario), HasSubstr("karma is at degree 3: missions are planned at degree "
                                           "4"));

  scenario.ground.script.steps.at(0).actions.emplace_back(
      ground_station::SetDegree{"karma", mission::ChangeDegree{4}});
  EXPECT_EQ(refused(scenario), "");
}

TEST(RefusedMissions, OneWithoutTasksIsNamedToo) {
  scenario::Scenario scenario = one_mission();
  scenario.uavs.at(0).degree = 3;
  for (auto& step : scenario.ground.script.steps) {
    for (auto& action : step.actions)
      if (auto* sent = std::get_if<SendMission>(&action)) sent->mission.tasks.clear();
  }
  EXPECT_THAT(refused(scenario), HasSubstr("the mission has no tasks"));
  EXPECT_THAT(refused(scenario), HasSubstr("karma is at degree 3"));
}

TEST(DomainWarnings, NameTheDomainsFile) {
  scenario::Scenario scenario = one_mission();
  EXPECT_TRUE(domain_warnings(scenario).empty());
  scenario.planning->domain_path = "own.lisp";
  scenario.planning->domain = "(defdomain own (\n  (:method (go ?_p) () ((fly)))))";
  EXPECT_THAT(to_text(domain_warnings(scenario)),
              HasSubstr("own.lisp:2:25: task 'fly' has neither method nor operator"));
}

}  // namespace
}  // namespace skein::deliberation_setup
