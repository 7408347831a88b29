// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario/operator_request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::scenario {
namespace {

using ground_station::OperatorDeed;
using ::testing::AllOf;
using ::testing::HasSubstr;

const char* const kComets = SKEIN_SOURCE_DIR "/scenarios/comets/confirmed.yaml";

RequestReader reader() {
  auto scenario = read_scenario(kComets);
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return RequestReader(std::make_shared<const Scenario>(std::move(*scenario)));
}

std::vector<std::string> texts_of(const std::string& request) {
  const auto deeds = reader().read(request);
  if (!deeds) ADD_FAILURE() << to_text(deeds.error());
  std::vector<std::string> texts;
  for (const OperatorDeed& deed : deeds.value_or(std::vector<OperatorDeed>())) {
    texts.push_back(ground_station::to_text(deed));
  }
  return texts;
}

std::string problems_of(const std::string& request) {
  const auto deeds = reader().read(request);
  return deeds ? "" : to_text(deeds.error());
}

TEST(RequestReader, TakesTheActionsOfScriptsAndThoseOfPeopleInTheOrderWritten) {
  EXPECT_THAT(texts_of(R"([{"take_in_hand": {"uav": "marvin"}}, {"ask": {"uav": "heliv"}},
                           {"keep": {"uav": "heliv"}}, {"let_go": {"uav": "marvin", "to": "bo"}},
                           {"answer": "end-monitoring"}, {"judge_alarm": {"alarm": 1, "as": "infirmed"}},
                           {"abort": {"uav": "karma"}}, {"finish": true}])"),
              ::testing::ElementsAre("take_in_hand marvin", "ask heliv", "keep heliv",
                                     "let_go marvin to bo", "answer end-monitoring",
                                     "judge_alarm 1 infirmed", "abort karma", "finish"));
}

TEST(RequestReader, TakesOneActionByItself) {
  EXPECT_THAT(texts_of("give_back: {uav: karma}"), ::testing::ElementsAre("give_back karma"));
}

// An operator of a team gives what its script gives.
TEST(RequestReader, TakesMissionsOfTheTeamWhereThereIsATeam) {
  auto two = read_scenario(SKEIN_SOURCE_DIR "/scenarios/team/two.yaml");
  ASSERT_TRUE(two.has_value()) << to_text(two.error());
  RequestReader reads(std::make_shared<const Scenario>(std::move(*two)));

  const auto deeds = reads.read(
      "[{global_mission: {id: 7, tasks: [{id: 71, task: [perceive, west, 5]}]}}, "
      "{declare_lost: {uav: heliv}}]");

  ASSERT_TRUE(deeds.has_value()) << to_text(deeds.error());
  EXPECT_EQ(deeds->size(), 2U);
  EXPECT_THAT(
      problems_of("{global_mission: {id: 7, tasks: [{id: 71, task: [perceive, west, 5]}]}}"),
      HasSubstr("the scenario has no team"));
}

// Nobody waits for it any more, with a team or without.
TEST(RequestReader, TakesWhoIsLostWithoutATeamToo) {
  EXPECT_TRUE(reader().read("{declare_lost: {uav: heliv}}").has_value());
  EXPECT_THAT(problems_of("{declare_lost: {uav: krama}}"), HasSubstr("did you mean"));
  EXPECT_TRUE(reader().read("{declare_found: {uav: heliv}}").has_value());
  EXPECT_THAT(problems_of("{declare_found: {uav: krama}}"), HasSubstr("did you mean"));
}

TEST(RequestReader, PutsAWayOverTheGroundItIsFlownOver) {
  const auto deeds = reader().read("go: {uav: marvin, to: [[10, 20], [30, 40]], altitude: 50}");

  ASSERT_TRUE(deeds) << to_text(deeds.error());
  const auto& steer = std::get<ground_station::SteerTo>(deeds->at(0));
  const world::Terrain terrain(read_scenario(kComets)->world.terrain);
  ASSERT_EQ(steer.points.size(), 2U);
  EXPECT_DOUBLE_EQ(steer.points[1].z(), terrain.elevation(30, 40) + 50);
}

// It was acknowledged, and refused by the vehicle a moment later, where no operator looked.
TEST(RequestReader, SaysWhatTheVehicleWouldRefuseOfAWay) {
  EXPECT_THAT(problems_of("go: {uav: marvin, to: [[10, 20], [30, 40]], altitude: 5000}"),
              AllOf(HasSubstr("10,20 is 5000 m above the ground there"), HasSubstr("30,40 is 5000"),
                    HasSubstr("at most the ceiling of marvin, ")));
  EXPECT_THAT(problems_of("go: {uav: marvin, to: [90000, 20], altitude: 50}"),
              AllOf(HasSubstr("90000,20 is outside the terrain"), HasSubstr("x from ")));
  EXPECT_THAT(problems_of("go: {uav: marvin, to: [10, 20, 9000]}"), HasSubstr("above the ground"));
  EXPECT_THAT(problems_of("go: {uav: marvin, to: [10, 20]}"), HasSubstr("--altitude"));
}

TEST(RequestReader, WhatDrivesNeedsNoHeight) {
  auto patrol = read_scenario(SKEIN_SOURCE_DIR "/scenarios/action/over-the-ridge.yaml");
  ASSERT_TRUE(patrol.has_value()) << to_text(patrol.error());
  const auto& uavs = patrol->uavs;
  const auto robot = std::find_if(uavs.begin(), uavs.end(),
                                  [](const UavSpec& one) { return one.model.ground.has_value(); });
  ASSERT_NE(robot, uavs.end());
  const std::string name = robot->name;
  RequestReader reads(std::make_shared<const Scenario>(std::move(*patrol)));

  const auto deeds = reads.read("go: {uav: " + name + ", to: [[10, 20], [30, 40]]}");

  ASSERT_TRUE(deeds.has_value()) << to_text(deeds.error());
  EXPECT_TRUE(std::get<ground_station::SteerTo>(deeds->at(0)).drives);
}

TEST(RequestReader, OpensAirThatNoScriptCloses) {
  EXPECT_THAT(texts_of("open_air: {name: drawn-by-ada}"),
              ::testing::ElementsAre("open_air drawn-by-ada"));
}

TEST(RequestReader, GivesEveryErrorWithItsPlaceAndTheNearestName) {
  const std::string problems = problems_of(
      "- take_in_hand: {uav: marvn}\n"
      "- land_now: {}\n"
      "- judge_alarm: {alarm: 0, as: burning}\n"
      "- go: {uav: karma}\n"
      "- {keep: {uav: karma}, finish: true}\n");

  EXPECT_THAT(problems, AllOf(HasSubstr("request:1:"), HasSubstr("did you mean 'marvin'?"),
                              HasSubstr("land_now"), HasSubstr("judge_alarm"), HasSubstr("go.to"),
                              HasSubstr("an action is one thing")));
}

TEST(RequestReader, RefusesWhatIsNoRequest) {
  for (const char* text : {"", "[]", "3", "{", "[[[[", "\"a\": 1\n\t- b", "finish: maybe"}) {
    EXPECT_NE(problems_of(text), "") << text;
  }
}

}  // namespace
}  // namespace skein::scenario
