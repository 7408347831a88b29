// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/mission_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using testing::at;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

MissionChecks checks() {
  MissionKnowledge knowledge;
  knowledge.vocabulary = mission::Vocabulary{
      {{"watch",
        {"watch", {mission::ParameterKind::kPlace, mission::ParameterKind::kDuration}, {}}}},
      {}};
  knowledge.places = {"P1", "P2"};
  return {knowledge, {"marvin", "heliv"}};
}

mission::UnitMission watch(const std::string& place, double seconds) {
  mission::UnitMission out;
  out.id = mission::MissionId(2);
  out.tasks.push_back({mission::GoalId(701), "watch", {place, seconds}, {}});
  return out;
}

std::vector<std::string> problems(const Request& request, Degree degree = 4,
                                  const std::vector<mission::GoalStatus>& goals = {}) {
  return checks().problems_of(request, {"marvin", degree, goals}, at(10));
}

TEST(MissionChecks, AMissionThatMakesSenseMayBeSent) {
  EXPECT_THAT(problems(watch("P1", 20)), IsEmpty());
}

TEST(MissionChecks, EveryReasonIsGivenAtOnce) {
  const auto reasons = problems(watch("P9", -1), 2);

  ASSERT_THAT(reasons, SizeIs(3));
  EXPECT_THAT(reasons[0], HasSubstr("degree 2"));
  EXPECT_THAT(reasons[1] + reasons[2], HasSubstr("P9"));
}

/// A ground station that has version 0xabc of "lift"; of the board, Marvin and Heliv.
std::vector<std::string> joint_problems(const Teammate& marvin, const Teammate& heliv,
                                        std::vector<std::string> members) {
  MissionKnowledge knowledge;
  knowledge.joint_tasks = {{"lift", 0xabc}};
  mission::UnitMission lift;
  lift.id = mission::MissionId(2);
  lift.tasks.push_back({mission::GoalId(701), "lift", {std::move(members)}, {}});
  const std::vector<mission::GoalStatus> none;
  const Addressee to{"marvin", 4, none, {{"marvin", marvin}, {"heliv", heliv}}};
  return MissionChecks(knowledge, {"marvin", "heliv"}).problems_of(lift, to, at(10));
}

const ModelVersions kSame = {{"lift", 0xabc}};

TEST(MissionChecks, AJointTaskOfWhoDeliberatesWithOneVersionMayBeSent) {
  EXPECT_THAT(joint_problems({4, kSame}, {5, kSame}, {"marvin", "heliv"}), IsEmpty());
  // Who told nothing yet is believed.
  EXPECT_THAT(joint_problems({4, kSame}, {4, {}}, {"marvin", "heliv"}), IsEmpty());
}

TEST(MissionChecks, AJointTaskOfAnotherVersionIsRefusedNamingBoth) {
  EXPECT_THAT(joint_problems({4, kSame}, {4, {{"lift", 0x123}}}, {"marvin", "heliv"}),
              ElementsAre("lift: heliv has version 0000000000000123 of its model, the ground "
                          "station 0000000000000abc"));
  EXPECT_THAT(joint_problems({4, {{"lift", 1}}}, {4, kSame}, {"marvin", "heliv"}),
              ElementsAre(HasSubstr("lift: marvin has version 0000000000000001")));
  EXPECT_THAT(joint_problems({4, kSame}, {4, {{"watch", 1}}}, {"marvin", "heliv"}),
              ElementsAre("lift: heliv has no model of it"));
}

TEST(MissionChecks, WhoTakesPartInAJointTaskDeliberates) {
  EXPECT_THAT(joint_problems({4, kSame}, {2, kSame}, {"marvin", "heliv"}),
              ElementsAre("lift: heliv is at degree 2 and does not deliberate, and its model lets "
                          "the ground station play no role"));
  EXPECT_THAT(joint_problems({4, kSame}, {3, {{"lift", 0x123}}}, {"heliv"}), SizeIs(3));
}

TEST(MissionChecks, APlaceMayBeNamedOnceItIsKnown) {
  MissionChecks checking = checks();
  const std::vector<mission::GoalStatus> none;
  const Addressee marvin{"marvin", 4, none};
  EXPECT_THAT(checking.problems_of(watch("alarm:1", 20), marvin, at(10)), SizeIs(1));

  checking.know_place("alarm:1");

  EXPECT_THAT(checking.problems_of(watch("alarm:1", 20), marvin, at(10)), IsEmpty());
  EXPECT_THAT(checking.problems_of(watch("alarm:2", 20), marvin, at(10)), SizeIs(1));
}

TEST(MissionChecks, AHighLevelTaskIsAskedForOnce) {
  const std::vector<mission::GoalStatus> goals = {{mission::GoalId(701), mission::MissionId(1),
                                                   "watch P2 10", mission::GoalState::kAchieved, "",
                                                   ""}};

  EXPECT_THAT(problems(watch("P1", 20), 4, goals),
              ElementsAre("high-level task 701 is known already: watch P2 10"));
}

TEST(MissionChecks, WithoutADomainWhatIsAskedForIsNotChecked) {
  const MissionChecks none;

  EXPECT_THAT(none.problems_of(watch("nowhere", -1), {"marvin", 4, {}}, at(1)), IsEmpty());
  EXPECT_THAT(none.problems_of(watch("nowhere", -1), {"marvin", 3, {}}, at(1)), SizeIs(1));
}

TEST(MissionChecks, DegreesGoFromOneToFive) {
  for (int degree = -1; degree <= 6; ++degree) {
    const bool is_built = degree >= 1 && degree <= 5;
    EXPECT_EQ(problems(mission::ChangeDegree{degree, false, true}).empty(), is_built) << degree;
  }
}

world::Volume tower() {
  world::Volume out;
  out.name = "tower";
  out.polygon = {{0, 0}, {10, 0}, {0, 10}};
  return out;
}

TEST(MissionChecks, AVolumeHasANameAnAreaAHeightAndATime) {
  EXPECT_THAT(problems(mission::ChangeWorld{tower(), false}), IsEmpty());
  world::Volume wrong;
  wrong.polygon = {{0, 0}, {NAN, 0}};
  wrong.floor = 10;
  wrong.ceiling = 10;
  wrong.when = {at(5), at(5)};

  EXPECT_THAT(problems(mission::ChangeWorld{wrong, false}), SizeIs(5));
  EXPECT_THAT(problems(mission::ChangeWorld{wrong, true}), SizeIs(1)) << "only the name counts";
}

TEST(MissionChecks, RequestsToAnExecutiveAreItsOwnBusiness) {
  EXPECT_THAT(problems(testing::start_of(1), 1), IsEmpty());
  EXPECT_THAT(problems(mission::CancelGoals{}, 1), IsEmpty());
}

}  // namespace
}  // namespace skein::ground_station
