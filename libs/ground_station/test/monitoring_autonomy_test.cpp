// SPDX-License-Identifier: Apache-2.0
// Missions, hand-over and changes of degree on the status board.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/ground_station/monitoring.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using mission::ChangeDegree;
using mission::GoalId;
using mission::GoalState;
using mission::MissionId;
using testing::abort_of;
using testing::at;
using ::testing::ElementsAre;
using testing::first;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::only;
using ::testing::SizeIs;
using testing::start_of;
using Effects = std::vector<Monitoring::Effect>;

Monitoring at_degree(Degree degree) { return Monitoring({{"marvin", degree}}); }

IssueCommand to_marvin(Request request, double expires = 100) {
  return {"marvin", std::move(request), at(expires), "step one"};
}

ChangeDegree to_degree(int degree, bool resume = true) { return {degree, false, resume}; }

HandOverReceived hand_over(int degree, double when = 5) {
  return {"marvin", {degree, {}, {}}, at(when)};
}

RequestReplyReceived accepted(std::uint64_t command) { return {CommandNumber(command), true, ""}; }

PlanBoardReceived board(Degree degree, double when) {
  return {"marvin", degree, true, {}, at(when)};
}

mission::UnitMission mission_of(std::uint64_t number, std::vector<std::uint64_t> goals) {
  mission::UnitMission out;
  out.id = MissionId(number);
  for (const std::uint64_t goal : goals) out.tasks.push_back({GoalId(goal), "watch", {}, {}});
  return out;
}

mission::GoalStatus goal(std::uint64_t number, GoalState state, std::uint64_t mission = 2) {
  return {GoalId(number), MissionId(mission), "watch P1", state, "", "step one"};
}

MissionPlanReceived plan_of(std::vector<mission::GoalStatus> goals, double when) {
  MissionPlanReceived out{"marvin", {}, at(when)};
  out.plan.revision = 1;
  out.plan.goals = std::move(goals);
  return out;
}

std::vector<std::string> sent(const Effects& effects) {
  std::vector<std::string> out;
  for (const SendRequest& request : only<SendRequest>(effects)) {
    out.push_back(skein::to_text(request.command));
  }
  return out;
}

// ---- commands wait for a change of degree ----

TEST(Monitoring, CommandsAfterAChangeOfDegreeWaitForTheHandOver) {
  Monitoring mcs = at_degree(3);

  EXPECT_THAT(sent(mcs.handle(to_marvin(to_degree(1)), at(1))), ElementsAre("1"));
  EXPECT_THAT(sent(mcs.handle(to_marvin(start_of(3)), at(2))), IsEmpty());
  EXPECT_THAT(sent(mcs.handle(to_marvin(abort_of(3)), at(2))), IsEmpty());
  EXPECT_THAT(only<ChangeSettled>(mcs.handle(accepted(1), at(3))), IsEmpty());
  const Effects over = mcs.handle(hand_over(1), at(5));
  const Effects released = mcs.handle(ReleaseCommands{"marvin"}, at(5));

  EXPECT_EQ(first<DegreeChanged>(over).degree, 1);
  EXPECT_THAT(only<ChangeSettled>(over), SizeIs(1));
  EXPECT_THAT(sent(over), IsEmpty()) << "what belongs to the change goes first";
  EXPECT_THAT(sent(released), ElementsAre("2", "3"));
}

TEST(Monitoring, WhatBelongsToTheChangeGoesAhead) {
  Monitoring mcs = at_degree(1);
  mcs.handle(to_marvin(to_degree(3)), at(1));
  mcs.handle(to_marvin(abort_of(7)), at(2));
  mcs.handle(hand_over(3), at(5));

  IssueCommand transfer = to_marvin(start_of(7));
  transfer.ahead = true;

  EXPECT_THAT(sent(mcs.handle(transfer, at(5))), ElementsAre("3"));
  EXPECT_THAT(sent(mcs.handle(ReleaseCommands{"marvin"}, at(5))), ElementsAre("2"));
}

TEST(Monitoring, TheNextChangeMakesTheRestWaitAgain) {
  Monitoring mcs = at_degree(3);
  mcs.handle(to_marvin(to_degree(1)), at(1));
  mcs.handle(to_marvin(start_of(3)), at(1));
  mcs.handle(to_marvin(to_degree(2)), at(1));
  mcs.handle(to_marvin(start_of(4)), at(1));
  mcs.handle(hand_over(1), at(5));

  EXPECT_THAT(sent(mcs.handle(ReleaseCommands{"marvin"}, at(5))), ElementsAre("2", "3"));
  mcs.handle(hand_over(2, 6), at(6));
  EXPECT_THAT(sent(mcs.handle(ReleaseCommands{"marvin"}, at(6))), ElementsAre("4"));
}

struct Unchanged {
  std::string name;
  Monitoring::Input input;
};
class ComesToNothing : public ::testing::TestWithParam<Unchanged> {};

TEST_P(ComesToNothing, AndTheOthersMayGo) {
  Monitoring mcs = at_degree(3);
  mcs.handle(to_marvin(to_degree(1), 50), at(1));
  mcs.handle(to_marvin(start_of(3)), at(2));

  const Effects effects = mcs.handle(GetParam().input, at(60));

  EXPECT_THAT(only<ChangeSettled>(effects), SizeIs(1));
  EXPECT_THAT(only<DegreeChanged>(effects), IsEmpty());
  EXPECT_THAT(sent(mcs.handle(ReleaseCommands{"marvin"}, at(60))), ElementsAre("2"));
}

INSTANTIATE_TEST_SUITE_P(
    Monitoring, ComesToNothing,
    ::testing::Values(Unchanged{"refused", RequestReplyReceived{CommandNumber(1), false, "no"}},
                      Unchanged{"undelivered", CommandUndelivered{CommandNumber(1)}},
                      Unchanged{"expired", Tick{}}),
    [](const auto& one) { return one.param.name; });

TEST(Monitoring, AnAcceptedChangeToTheSameDegreeIsSettled) {
  Monitoring mcs = at_degree(3);
  mcs.handle(to_marvin(to_degree(3)), at(1));

  EXPECT_THAT(only<ChangeSettled>(mcs.handle(accepted(1), at(2))), SizeIs(1));
}

TEST(Monitoring, AnAcceptedChangeWithoutHandOverIsSettledByTheBoardInTheEnd) {
  Monitoring mcs = at_degree(3);
  mcs.handle(to_marvin(to_degree(2), 50), at(1));
  mcs.handle(accepted(1), at(2));
  EXPECT_THAT(only<DegreeChanged>(mcs.handle(board(2, 2), at(3))), IsEmpty());

  ASSERT_EQ(mcs.next_wakeup(), at(55));
  const Effects effects = mcs.handle(Tick{}, at(55));

  EXPECT_EQ(first<DegreeChanged>(effects).degree, 2);
  EXPECT_THAT(only<ChangeSettled>(effects), SizeIs(1));
  EXPECT_EQ(mcs.next_wakeup(), std::nullopt);
}

TEST(Monitoring, ABoardOlderThanTheHandOverDoesNotTellTheDegree) {
  Monitoring mcs = at_degree(3);
  mcs.handle(hand_over(1, 5), at(5));

  EXPECT_THAT(only<DegreeChanged>(mcs.handle(board(3, 4), at(6))), IsEmpty());
  EXPECT_EQ(first<DegreeChanged>(mcs.handle(board(3, 7), at(7))).degree, 3);
}

TEST(Monitoring, ARestartSendsAnUnansweredChangeAgainButNotWhatWaits) {
  Monitoring mcs = at_degree(1);
  mcs.handle(to_marvin(to_degree(3)), at(1));
  mcs.handle(to_marvin(start_of(3)), at(1));

  EXPECT_THAT(sent(mcs.handle(PeerReachable{"marvin", true, true}, at(2))), ElementsAre("1"));
}

TEST(Monitoring, ARestartAfterTheAnswerSettlesTheChange) {
  Monitoring mcs = at_degree(3);
  mcs.handle(to_marvin(to_degree(1)), at(1));
  mcs.handle(accepted(1), at(2));

  EXPECT_THAT(only<ChangeSettled>(mcs.handle(PeerReachable{"marvin", true, true}, at(3))),
              SizeIs(1));
}

TEST(Monitoring, WhatExpiredWhileItWaitedIsNotSent) {
  Monitoring mcs = at_degree(3);
  mcs.handle(to_marvin(to_degree(1)), at(1));
  mcs.handle(to_marvin(start_of(3), 4), at(2));
  mcs.handle(hand_over(1), at(5));

  const Effects effects = mcs.handle(ReleaseCommands{"marvin"}, at(5));

  EXPECT_THAT(sent(effects), IsEmpty());
  EXPECT_EQ(first<CommandChanged>(effects).state, CommandState::kExpired);
}

// ---- taken in hand ----

ChangeHands hands(ChangeHands::Way way, bool interrupt = false) {
  return {"marvin", way, interrupt, at(100), "operator one"};
}

std::optional<ChangeDegree> asked(const Effects& effects) {
  const auto requests = only<SendRequest>(effects);
  if (requests.empty()) return std::nullopt;
  return std::get<ChangeDegree>(requests[0].request);
}

TEST(Monitoring, WhoIsTakenInHandIsGivenBackToTheDegreeBefore) {
  Monitoring mcs = at_degree(4);

  const auto taken = asked(mcs.handle(hands(ChangeHands::Way::kTake, true), at(1)));
  mcs.handle(hand_over(1), at(2));
  mcs.handle(hands(ChangeHands::Way::kTake), at(3));
  mcs.handle(accepted(2), at(3));
  const auto given = asked(mcs.handle(hands(ChangeHands::Way::kGiveBack), at(4)));

  EXPECT_EQ(taken, (ChangeDegree{1, true, true}));
  EXPECT_EQ(given, (ChangeDegree{4, false, true})) << "taken twice is taken once";
}

TEST(Monitoring, TheDegreeBeforeIsTheOneAskedFor) {
  Monitoring mcs = at_degree(4);
  mcs.handle(to_marvin(to_degree(2)), at(1));
  mcs.handle(hands(ChangeHands::Way::kTake), at(1));
  mcs.handle(hand_over(2, 2), at(2));
  mcs.handle(ReleaseCommands{"marvin"}, at(2));
  mcs.handle(hand_over(1, 3), at(3));

  EXPECT_EQ(asked(mcs.handle(hands(ChangeHands::Way::kGiveBack), at(4)))->degree, 2);
}

TEST(Monitoring, WhoWasNotTakenCannotBeGivenBack) {
  Monitoring mcs = at_degree(1);

  const Effects effects = mcs.handle(hands(ChangeHands::Way::kGiveBack), at(1));

  EXPECT_THAT(first<Anomaly>(effects).why, HasSubstr("was not taken in hand"));
  EXPECT_THAT(only<CommandChanged>(effects), IsEmpty());
}

// ---- refused at the ground ----

TEST(Monitoring, AMissionBelowDegreeFourIsRefusedWithoutBeingSent) {
  Monitoring mcs = at_degree(3);

  const Effects effects = mcs.handle(to_marvin(mission_of(2, {701})), at(1));

  const auto changes = only<CommandChanged>(effects);
  ASSERT_THAT(changes, SizeIs(2));
  EXPECT_EQ(changes[0].what, "MISSION 2 (1 task)");
  EXPECT_EQ(changes[1].state, CommandState::kRefused);
  EXPECT_EQ(changes[1].why, "marvin is at degree 3: missions are planned at degree 4");
  EXPECT_THAT(sent(effects), IsEmpty());
  EXPECT_EQ(first<MissionChanged>(effects).stage, MissionStage::kRefused);
}

TEST(Monitoring, AMissionAfterTheChangeToDegreeFourIsCheckedAfterIt) {
  Monitoring mcs = at_degree(3);
  mcs.handle(to_marvin(to_degree(4)), at(1));
  mcs.handle(to_marvin(mission_of(2, {701})), at(1));
  mcs.handle(hand_over(4), at(2));

  EXPECT_THAT(sent(mcs.handle(ReleaseCommands{"marvin"}, at(2))), ElementsAre("2"));
}

// ---- missions ----

std::vector<std::pair<std::uint64_t, GoalState>> goals_told(const Effects& effects) {
  std::vector<std::pair<std::uint64_t, GoalState>> out;
  for (const GoalChanged& change : only<GoalChanged>(effects)) {
    out.emplace_back(change.goal.value(), change.state);
  }
  return out;
}

std::vector<MissionStage> stages(const Effects& effects) {
  std::vector<MissionStage> out;
  for (const MissionChanged& change : only<MissionChanged>(effects)) out.push_back(change.stage);
  return out;
}

TEST(Monitoring, GoalsAreToldWhenTheirStateChanges) {
  Monitoring mcs = at_degree(4);

  EXPECT_THAT(goals_told(mcs.handle(plan_of({goal(701, GoalState::kPlanned)}, 1), at(1))),
              ElementsAre(std::pair(701, GoalState::kPlanned)));
  EXPECT_THAT(goals_told(mcs.handle(plan_of({goal(701, GoalState::kPlanned)}, 2), at(2))),
              IsEmpty());
  EXPECT_THAT(goals_told(mcs.handle(plan_of({goal(701, GoalState::kUnderWay)}, 3), at(3))),
              ElementsAre(std::pair(701, GoalState::kUnderWay)));
  EXPECT_EQ(mcs.board(at(3)).uavs[0].plan.revision, 1U);
  EXPECT_THAT(mcs.board(at(3)).uavs[0].goals, SizeIs(1));
}

TEST(Monitoring, AnOlderPlanDoesNotUndoAHandOver) {
  Monitoring mcs = at_degree(4);
  HandOverReceived handed = hand_over(3, 5);
  handed.hand_over.goals = {goal(701, GoalState::kHandedOver)};
  mcs.handle(handed, at(5));

  EXPECT_THAT(goals_told(mcs.handle(plan_of({goal(701, GoalState::kPlanned)}, 4), at(6))),
              IsEmpty());
  EXPECT_EQ(mcs.board(at(6)).uavs[0].goals[0].state, GoalState::kHandedOver);
}

struct Stages {
  std::string name;
  std::vector<GoalState> goals;
  std::vector<MissionStage> told;
};
class StageOfMission : public ::testing::TestWithParam<Stages> {};

TEST_P(StageOfMission, FollowsFromItsGoals) {
  Monitoring mcs = at_degree(4);
  std::vector<mission::GoalStatus> goals;
  for (const GoalState state : GetParam().goals) goals.push_back(goal(701 + goals.size(), state));

  EXPECT_EQ(stages(mcs.handle(plan_of(goals, 1), at(1))), GetParam().told);
  EXPECT_THAT(stages(mcs.handle(plan_of(goals, 2), at(2))), IsEmpty()) << "told once";
}

INSTANTIATE_TEST_SUITE_P(
    Monitoring, StageOfMission,
    ::testing::Values(
        Stages{"open", {GoalState::kAchieved, GoalState::kPlanned}, {}},
        Stages{"failed_but_open", {GoalState::kFailed, GoalState::kUnderWay}, {}},
        Stages{"handed_over", {GoalState::kAchieved, GoalState::kHandedOver}, {}},
        Stages{"achieved", {GoalState::kAchieved, GoalState::kAchieved}, {MissionStage::kAchieved}},
        Stages{"the_rest_cancelled",
               {GoalState::kAchieved, GoalState::kCancelled},
               {MissionStage::kAchieved}},
        Stages{"failed", {GoalState::kAchieved, GoalState::kFailed}, {MissionStage::kFailed}},
        Stages{"cancelled", {GoalState::kCancelled}, {}}),
    [](const auto& one) { return one.param.name; });

TEST(Monitoring, OutcomesTellWhetherAMissionIsPlanned) {
  Monitoring mcs = at_degree(4);

  EXPECT_THAT(stages(mcs.handle(MissionOutcomeReceived{"marvin", {MissionId(2), true, {}}}, at(1))),
              ElementsAre(MissionStage::kPlanned));
  EXPECT_THAT(
      stages(mcs.handle(MissionOutcomeReceived{"marvin", {MissionId(3), false, {"no"}}}, at(1))),
      ElementsAre(MissionStage::kRefused));
}

TEST(Monitoring, TheLastDecisionsAreKept) {
  Monitoring mcs = at_degree(4);
  for (std::uint64_t i = 1; i <= UavOnBoard::kDecisionsKept + 3; ++i) {
    mission::Decision decision;
    decision.number = i;
    mcs.handle(DecisionReceived{"marvin", decision}, at(1));
  }

  const auto decisions = mcs.board(at(2)).uavs[0].decisions;

  ASSERT_THAT(decisions, SizeIs(UavOnBoard::kDecisionsKept));
  EXPECT_EQ(decisions.front().number, 4U);
}

TEST(Monitoring, AMissionSentAgainAfterARestartIsToldAgain) {
  Monitoring mcs = at_degree(4);
  mcs.handle(plan_of({goal(701, GoalState::kPlanned)}, 1), at(1));
  mcs.handle(MissionOutcomeReceived{"marvin", {MissionId(2), true, {}}}, at(1));
  mcs.handle(PeerReachable{"marvin", true, true}, at(2));
  EXPECT_THAT(mcs.board(at(2)).uavs[0].goals, IsEmpty());

  EXPECT_THAT(goals_told(mcs.handle(plan_of({goal(701, GoalState::kPlanned)}, 3), at(3))),
              SizeIs(1));
  EXPECT_THAT(stages(mcs.handle(MissionOutcomeReceived{"marvin", {MissionId(2), true, {}}}, at(3))),
              SizeIs(1));
}

TEST(Monitoring, ARequestToAllGoesToEach) {
  Monitoring mcs({{"marvin", 4}, {"heliv", 3}});
  mission::ChangeWorld open;
  open.volume.name = "tower";
  open.remove = true;

  const Effects effects = mcs.handle(IssueToAll{open, at(50), "step one"}, at(1));

  const auto requests = only<SendRequest>(effects);
  ASSERT_THAT(requests, SizeIs(2));
  EXPECT_EQ(requests[0].uav, "marvin");
  EXPECT_EQ(requests[1].uav, "heliv");
  EXPECT_EQ(requests[1].asked_by, "step one");
}

TEST(Monitoring, WhatComesFromUnknownUavsAboutMissionsIsAnAnomaly) {
  Monitoring mcs = at_degree(4);
  const std::vector<Monitoring::Input> inputs = {
      MissionPlanReceived{"karma", {}},
      HandOverReceived{"karma", {}},
      DecisionReceived{"karma", {}},
      MissionOutcomeReceived{"karma", {}},
      ReleaseCommands{"karma"},
      ChangeHands{"karma", ChangeHands::Way::kTake, false, at(9)}};

  for (const Monitoring::Input& input : inputs) {
    const Effects effects = mcs.handle(input, at(1));

    ASSERT_THAT(effects, SizeIs(1));
    EXPECT_THAT(first<Anomaly>(effects).why, HasSubstr("unknown UAV 'karma'"));
  }
}

}  // namespace
}  // namespace skein::ground_station
