// SPDX-License-Identifier: Apache-2.0
// Missions, degrees, plans and hand-over on the wire of the ground node.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/translation/missions.hpp"
#include "skein/translation/tasks.hpp"
#include "testing/station.hpp"

namespace skein::ground {
namespace {

namespace gs = ground_station;
using mission::GoalId;
using mission::MissionId;
using testing::at;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::Station;
using testing::step;

mission::UnitMission two_tasks() {
  mission::UnitMission out;
  out.id = MissionId(2);
  out.tasks = {{GoalId(701), "watch", {std::string("P1"), 20.0}, {}},
               {GoalId(702), "home", {}, {}}};
  return out;
}

/// At 1 s the action is done.
gs::Script script_of(gs::Action action) {
  gs::Script script;
  script.steps.push_back(step("go", {gs::AtTime{at(1)}}, {std::move(action)}));
  return script;
}

wire::HandOver handed_over(int degree, double when) {
  mission::HandOver hand_over;
  hand_over.degree = degree;
  mission::HeldTask running, later;
  running.task.id = executive::TaskId(5);
  running.task.type = "goto";
  running.state = executive::TaskState::kRunning;
  running.in_executive = true;
  later.task.id = executive::TaskId(7);
  later.task.type = "land";
  hand_over.tasks = {running, later};
  wire::HandOver sample = translation::to_wire("marvin", hand_over);
  sample.header.mission_time = at(when).count();
  return sample;
}

TEST(GroundNode, SendsAMissionAsANumberedRequest) {
  Station station(script_of(gs::SendMission{"marvin", two_tasks(), {}}), 4);

  station.give(node::Wakeup{}, 1);

  const auto requests = station.sent<wire::MissionRequest>();
  ASSERT_THAT(requests, SizeIs(1));
  EXPECT_EQ(requests[0].first, "marvin");
  EXPECT_EQ(requests[0].second.command, 1U);
  EXPECT_FALSE(requests[0].second.cancel);
  EXPECT_EQ(requests[0].second.asked_by, "step go");
  EXPECT_THAT(requests[0].second.tasks, SizeIs(2));
  EXPECT_EQ(station.records("command")[0].text("what"), "MISSION 2 (2 tasks)");
  EXPECT_EQ(station.all<node::Send>()[0].expires, at(61));
}

TEST(GroundNode, RefusesAMissionThatItCanKnowToBeWrong) {
  Station station(script_of(gs::SendMission{"marvin", two_tasks(), {}}), 3);

  station.give(node::Wakeup{}, 1);

  EXPECT_TRUE(station.sends_nothing());
  ASSERT_THAT(station.records("command"), SizeIs(2));
  EXPECT_EQ(station.records("command")[1].text("state"), "refused");
}

TEST(GroundNode, SendsCancellationsDegreesAndChangesOfTheWorld) {
  mission::CancelGoals cancel;
  cancel.goals = {GoalId(701)};
  world::Volume tower;
  tower.name = "tower";
  tower.polygon = {{0, 0}, {10, 0}, {0, 10}};
  gs::Script script;
  script.steps.push_back(step("go", {gs::AtTime{at(1)}},
                              {gs::CancelMission{"marvin", cancel}, gs::CloseAir{tower, {}},
                               gs::TakeInHand{"marvin", true}}));
  Station station(script, 4);

  station.give(node::Wakeup{}, 1);

  ASSERT_THAT(station.sent<wire::MissionRequest>(), SizeIs(1));
  EXPECT_TRUE(station.sent<wire::MissionRequest>()[0].second.cancel);
  EXPECT_EQ(station.sent<wire::MissionRequest>()[0].second.command, 1U);
  ASSERT_THAT(station.sent<wire::WorldChange>(), SizeIs(2)) << "to all UAVs";
  EXPECT_EQ(station.sent<wire::WorldChange>()[1].second.name, "tower");
  ASSERT_THAT(station.sent<wire::DegreeCommand>(), SizeIs(1));
  const wire::DegreeCommand degree = station.sent<wire::DegreeCommand>()[0].second;
  EXPECT_EQ(degree.degree, 1);
  EXPECT_TRUE(degree.interrupt);
  EXPECT_EQ(degree.asked_by, "step go");
  EXPECT_EQ(degree.command, 4U);
}

TEST(GroundNode, TakesOverWhatIsHandedOverAndHoldsTheRest) {
  Station station({}, 4);

  station.from("marvin", handed_over(1, 5), 5);

  const auto requests = station.sent<wire::FunctionalRequest>();
  ASSERT_THAT(requests, SizeIs(1));
  EXPECT_EQ(requests[0].second.id, 5U);
  ASSERT_THAT(station.records("held"), SizeIs(1));
  EXPECT_EQ(station.records("held")[0].text("uav"), "marvin");
  EXPECT_EQ(station.records("held")[0].number("tasks"), 1);
  EXPECT_EQ(station.records("held")[0].text("state"), "held");
}

TEST(GroundNode, ResumesWhatItHolds) {
  gs::Script script;
  script.steps.push_back(
      step("resume", {gs::OnDegree{"marvin", 3}}, {gs::ResumePlan{"marvin", {}}}));
  Station station(script, 4);

  station.from("marvin", handed_over(3, 5), 5);

  const auto requests = station.sent<wire::TaskRequest>();
  ASSERT_THAT(requests, SizeIs(1));
  EXPECT_EQ(requests[0].second.task.id, 7U);
  ASSERT_THAT(station.records("held"), SizeIs(2));
  EXPECT_EQ(station.records("held")[1].text("state"), "resumed");
}

TEST(GroundNode, AStepFollowsWhatBecomesOfAMission) {
  gs::Script script;
  script.steps.push_back(
      step("planned", {gs::OnMission{"marvin", MissionId(2), gs::MissionStage::kPlanned}}, {}));
  script.steps.push_back(step(
      "end", {gs::OnGoal{"marvin", GoalId(701), mission::GoalState::kAchieved}}, {gs::Finish{}}));
  Station station(script, 4);

  station.from("marvin",
               translation::to_wire("marvin", mission::MissionOutcome{MissionId(2), true, {}}), 1);
  EXPECT_THAT(station.records("step"), SizeIs(1));
  mission::PlanReport report;
  report.revision = 1;
  report.goals = {
      {GoalId(701), MissionId(2), "watch P1 20", mission::GoalState::kAchieved, "", ""}};
  station.from("marvin", translation::to_wire("marvin", report), 2);

  EXPECT_THAT(station.all<node::Finish>(), SizeIs(1));
}

TEST(GroundNode, ADecisionSendsNothing) {
  Station station({}, 4);

  station.from("marvin", translation::to_wire("marvin", mission::Decision{}), 1);

  EXPECT_TRUE(station.sends_nothing());
}

TEST(GroundNode, AHandOverThatMakesNoSenseIsDropped) {
  Station station({}, 4);
  wire::HandOver wrong = handed_over(1, 5);
  wrong.degree = 9;

  station.from("marvin", wrong, 5);

  EXPECT_TRUE(station.sends_nothing());
  ASSERT_THAT(station.records("dropped"), SizeIs(1));
  EXPECT_EQ(station.records("dropped")[0].text("slot"), "HandOver");
  EXPECT_NE(station.records("dropped")[0].text("field"), "header.origin");
}

TEST(GroundNode, AHandOverFromAStrangerTakesNothingOver) {
  Station station({}, 4);

  station.from_stranger(handed_over(1, 5), 5);
  EXPECT_TRUE(station.sends_nothing());
  station.from("sim", handed_over(1, 5), 5);
  EXPECT_TRUE(station.sends_nothing());
}

}  // namespace
}  // namespace skein::ground
