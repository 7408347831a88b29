// SPDX-License-Identifier: Apache-2.0
// The right to decide is given up and taken again. Source: spec 1.2.
#include "skein/functional/steering_ids.hpp"
#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Desk under_way() {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted(
      {701, 702}, {TaskOf(100, "goto", 701).takes(100, 120), TaskOf(101, "goto", 702).after(100),
                   TaskOf(102, "takeshot", 702).during(101).stopped_by(101)}));
  desk.runs(100);
  return desk;
}

TEST(SupervisorHandOver, GivesWhatIsOnlyPlannedWithItsConditions) {
  Desk desk = under_way();

  desk.at(10).give(Disengage{"degree 3 by operator"});

  EXPECT_FALSE(desk.supervisor.engaged());
  ASSERT_EQ(desk.of<HandedOver>().size(), 1U);
  const auto held = desk.of<HandedOver>()[0].tasks;
  ASSERT_EQ(held.size(), 2U);
  EXPECT_EQ(held[0].task.id, TaskId{101});
  EXPECT_EQ(held[0].origin, GoalId{702});
  EXPECT_FALSE(held[0].in_executive);
  EXPECT_EQ(held[0].task.preconditions.size(), 1U);
  EXPECT_EQ(held[1].task.exit.size(), 1U);
  EXPECT_EQ(desk.state_of(701), "under-way");
  EXPECT_EQ(desk.state_of(702), "handed-over");
}

TEST(SupervisorHandOver, StopsCommitmentAndForgetsItsJob) {
  Desk desk = under_way();
  desk.add(a_mission(2, {703}));
  desk.at(10).give(Disengage{"degree 3"});
  EXPECT_EQ(desk.state_of(703), "handed-over");

  desk.finish(inserted({703, 702}, {TaskOf(103, "goto", 703), TaskOf(104, "goto", 702)}));
  EXPECT_THAT(desk.requests(), IsEmpty());
  desk.at(110).ends(100);
  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_EQ(desk.state_of(701), "achieved");
  EXPECT_FALSE(desk.supervisor.next_wakeup().has_value());
}

TEST(SupervisorHandOver, GoalsAreAchievedByWhoeverCarriesThemOut) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 3"});
  desk.at(110).ends(100);

  desk.seen(101, TaskState::kScheduled);
  desk.runs(101);
  desk.runs(102);
  EXPECT_EQ(desk.state_of(702), "under-way");
  desk.at(125).ends(101);
  desk.aborted(102, "exit conditions satisfied");

  EXPECT_EQ(desk.state_of(702), "achieved");
}

TEST(SupervisorHandOver, WithResumePlansWhatIsLeftFromHere) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 1"});
  desk.aborted_as_asked(100);
  EXPECT_EQ(desk.state_of(701), "handed-over");

  desk.at(50).give(Engage{true, "given back"});

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining.size(), 2U);
  EXPECT_EQ(desk.repair().base.situation.next_id, TaskId{103});
  desk.finish(repaired(RepairStep::kReplan, {701, 702},
                       {TaskOf(103, "goto", 701), TaskOf(104, "goto", 702).after(103)}));
  EXPECT_THAT(desk.requests(), Contains("START 103"));
  EXPECT_EQ(desk.state_of(702), "planned");
}

/// Its operator looked by hand (7) at degree 1, which goes on; planned anew on return.
Desk given_back_while_looking() {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 1"});
  desk.aborted_as_asked(100);
  desk.seen(7, TaskState::kRunning, {}, "perceive");
  desk.at(50).give(Engage{true, "given back", std::nullopt, {TaskId{7}}});
  desk.finish(repaired(RepairStep::kReplan, {701, 702},
                       {TaskOf(103, "goto", 701), TaskOf(104, "goto", 702).after(103)}));
  return desk;
}

// Found by random missions (--anything --busy 6): conditions named a task that the executive on
// board did not have yet, and each goal failed within a second.
TEST(SupervisorHandOver, NothingOfThePlanFollowsATaskThatTheExecutiveHasNotYet) {
  Desk desk = given_back_while_looking();
  EXPECT_THAT(desk.requests(), IsEmpty());

  desk.at(51).seen(7, TaskState::kScheduled, {}, "perceive");

  EXPECT_THAT(desk.requests(), Contains("START 103"));
  EXPECT_THAT(desk.started(103)->task.preconditions, SizeIs(1)) << "over 7";
}

TaskSeen wait_without_end(TaskState state) { return {{TaskId{7}, "wait", state, {}}, true}; }

// Found by an outsider's missions over DDS (2003): its operator's wait had no end, and so the UAV
// hovered until the end of the mission.
TEST(SupervisorHandOver, AWaitWithoutEndOfItsOperatorsIsNotWaitedFor) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 1"});
  desk.aborted_as_asked(100);
  desk.seen(7, TaskState::kRunning, {}, "wait");
  desk.at(50).give(Engage{true, "given back", std::nullopt, {TaskId{7}}});
  desk.finish(repaired(RepairStep::kReplan, {701, 702},
                       {TaskOf(103, "goto", 701).over(7), TaskOf(104, "goto", 702).after(103)}));

  desk.at(51).give(wait_without_end(TaskState::kScheduled));

  ASSERT_THAT(desk.requests(), Contains("START 103"));
  EXPECT_THAT(desk.started(103)->task.preconditions, IsEmpty());
}

TEST(SupervisorHandOver, AWaitWithoutEndIsNotWaitedForOnceItHasBegun) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.give(wait_without_end(TaskState::kScheduled));
  desk.finish(inserted({701}, {TaskOf(100, "goto", 701)}));
  ASSERT_THAT(desk.requests(), Contains("START 100"));
  EXPECT_THAT(desk.started(100)->task.preconditions, SizeIs(1)) << "over 7";

  desk.at(2).give(wait_without_end(TaskState::kStarted));

  ASSERT_THAT(desk.requests(), Contains("UPDATE 100"));
  for (const ToExecutive& sent : desk.of<ToExecutive>()) {
    const auto* update = std::get_if<executive::UpdateConditions>(&sent.input);
    ASSERT_NE(update, nullptr) << "the plan's only motion, and nothing else";
    EXPECT_THAT(*update->preconditions, IsEmpty());
  }
}

/// Goal 701 flies at the ground station's executive; 702 is planned behind it on return.
Desk given_back_while_flying() {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 1"});
  desk.at(98).give(Engage{true, "given back", std::nullopt, {TaskId{100}}});
  desk.finish(repaired(RepairStep::kReplan, {702}, {TaskOf(103, "goto", 702).after(100)}));
  return desk;
}

TEST(SupervisorHandOver, NothingOfThePlanFollowsAnOwnTaskThatTheExecutiveHasNotYet) {
  Desk back = given_back_while_flying(), ended = given_back_while_flying();
  EXPECT_THAT(back.requests(), IsEmpty());

  back.at(99).seen(100, TaskState::kScheduled, {}, "goto");
  ended.at(99).seen(100, TaskState::kEnded, {}, "goto");

  EXPECT_THAT(back.requests(), Contains("START 103"));
  EXPECT_THAT(back.started(103)->task.preconditions, SizeIs(1)) << "100 ended";
  EXPECT_THAT(ended.requests(), Contains("START 103"));
  EXPECT_THAT(ended.started(103)->task.preconditions, IsEmpty());
}

/// Goal 701, a flight and a look behind it, is with the ground station's executive, where the look
/// still waits when the UAV is given back.
Desk given_back_before_a_look(std::vector<TaskId> carried_out) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted(
      {701, 702}, {TaskOf(100, "goto", 701).takes(100, 120),
                   TaskOf(101, "perceive", 701).after(100), TaskOf(102, "goto", 702).after(101)}));
  desk.runs(100);
  desk.at(10).give(Disengage{"degree 1"});
  if (carried_out.empty()) desk.at(97).seen(100, TaskState::kEnded, {}, "goto");
  desk.at(98).give(Engage{true, "given back", std::nullopt, std::move(carried_out)});
  desk.finish(repaired(RepairStep::kReplan, {702}, {TaskOf(103, "goto", 702).after(101)}));
  return desk;
}

// Found by random missions (--anything --busy 1008002): over 9,600 bit/s the ground heard of its
// new degree after 39 s. Conditions of the next goal named a look that the executive on board did
// not have, and it failed after three tries; had the look never come, its goal would have been
// awaited for ever.
TEST(SupervisorHandOver, WhatWaitsElsewhereIsAwaitedAndThenPlannedAnew) {
  Desk back = given_back_before_a_look({}), silent = given_back_before_a_look({});
  EXPECT_THAT(back.requests(), IsEmpty());

  back.at(99).seen(101, TaskState::kScheduled, {}, "perceive");
  EXPECT_FALSE(back.job_started());
  EXPECT_THAT(back.requests(), Contains("START 103"));

  silent.at(103).give(Tick{});
  ASSERT_TRUE(silent.job_started());
  ASSERT_EQ(silent.of<NotGivenBack>().size(), 1U) << "nobody else would say that it is over";
  EXPECT_EQ(silent.of<NotGivenBack>()[0].event.id, TaskId(101));
  EXPECT_EQ(silent.of<NotGivenBack>()[0].event.state, TaskState::kAborted);
  EXPECT_EQ(silent.repair().remaining.size(), 2U);
  EXPECT_THAT(silent.repair().standing.tasks, IsEmpty());
  silent.at(137).seen(101, TaskState::kScheduled, {}, "perceive");
  EXPECT_THAT(silent.requests(), ElementsAre("ABORT 101")) << "it comes all the same";
}

TEST(SupervisorHandOver, WhatTheVehicleCarriesOutForAnotherIsAwaitedToItsEnd) {
  Desk desk = given_back_before_a_look({TaskId{100}});
  desk.at(103).give(Tick{});
  EXPECT_FALSE(desk.job_started());
  EXPECT_THAT(desk.requests(), IsEmpty());

  desk.at(110).seen(100, TaskState::kEnded, {}, "goto");

  ASSERT_TRUE(desk.job_started()) << "the look never came";
  EXPECT_EQ(desk.repair().remaining.size(), 2U);
}

// Found by random missions (--sharing 88): a joint task that the ground station's executive had was
// dropped meanwhile; that was told to nobody, and it began once it was back.
TEST(SupervisorHandOver, WhatIsStoppedWhileAnotherExecutiveHasItIsStoppedOnceItIsBack) {
  Desk desk = given_back_before_a_look({});
  desk.give(CancelMission{{{GoalId{701}}, {}, true}, "operator"});
  EXPECT_THAT(desk.requests(), ::testing::Not(Contains("ABORT 101")));

  desk.at(99).seen(101, TaskState::kScheduled, {}, "perceive");

  EXPECT_THAT(desk.requests(), Contains("ABORT 101"));
  desk.at(100).give(Tick{});
  EXPECT_THAT(desk.requests(), ::testing::Not(Contains("ABORT 101"))) << "once";
}

TEST(SupervisorHandOver, WithoutResumeWhatDoesNotComeBackIsHandedOver) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 1"});
  desk.at(50).give(Engage{false, "degree 4"});

  desk.at(55).give(Tick{});

  EXPECT_FALSE(desk.job_started());
  EXPECT_EQ(desk.state_of(701), "handed-over");
}

TEST(SupervisorHandOver, WhatEndsElsewhereOrDoesNotComeBackIsNotFollowed) {
  Desk ended = given_back_while_looking(), silent = given_back_while_looking();

  ended.at(52).seen(7, TaskState::kEnded, {}, "perceive");
  silent.at(54.9).give(Tick{});
  EXPECT_THAT(silent.requests(), IsEmpty());
  ASSERT_TRUE(silent.supervisor.next_wakeup().has_value());
  silent.at(55).give(Tick{});

  for (const Desk* desk : {&ended, &silent}) {
    EXPECT_THAT(desk->requests(), Contains("START 103"));
    EXPECT_THAT(desk->started(103)->task.preconditions, IsEmpty());
  }
}

TEST(SupervisorHandOver, TakenInHandAgainItAwaitsNothingOfAnother) {
  Desk desk = given_back_while_looking();
  desk.at(52).give(Disengage{"degree 1"});
  desk.at(56).give(Tick{});
  desk.at(57).give(Engage{true, "given back", std::nullopt, {}});

  EXPECT_TRUE(desk.job_started()) << "the look goes on, as far as it knows";
}

TEST(SupervisorHandOver, WithoutResumeLeavesThemAndPlansNewMissionsOnly) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 3"});

  desk.at(50).give(Engage{false, "degree 4"});
  EXPECT_FALSE(desk.job_started());
  desk.add(a_mission(2, {703}));

  EXPECT_EQ(desk.state_of(702), "handed-over");
  EXPECT_THAT(desk.insertion().planned, IsEmpty());
  EXPECT_EQ(desk.insertion().standing.tasks.size(), 1U);
}

TEST(SupervisorHandOver, KeepsWithResumeWhatTheGroundHadResumed) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 3"});
  desk.seen(101, TaskState::kScheduled);

  desk.at(50).give(Engage{true, "given back"});

  EXPECT_FALSE(desk.job_started());
  EXPECT_EQ(desk.state_of(702), "planned");
}

TEST(SupervisorHandOver, KnowsOfAirThatWasClosedMeanwhile) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 3"});
  mission::ChangeWorld change;
  change.volume = {"fire", {{0, 0}, {9, 0}, {0, 9}}, 0, 10, {}};
  desk.give(WorldChanged{change});
  EXPECT_TRUE(desk.of<Answer>()[0].accepted);

  desk.give(Engage{true, "given back"});

  EXPECT_EQ(desk.repair().base.world->volumes.size(), 1U);
}

TEST(SupervisorHandOver, PlansAnewWhatTheExecutiveNoLongerHas) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 1"});

  desk.at(50).give(Engage{true, "given back", std::vector<TaskId>{}});

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining.size(), 2U);
  EXPECT_THAT(desk.repair().standing.tasks, IsEmpty());
  EXPECT_THAT(desk.requests(), IsEmpty());
}

TEST(SupervisorHandOver, PlansAnewAGoalOfWhichATaskWasLostMeanwhile) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 3"});
  desk.seen(101, TaskState::kScheduled);
  desk.aborted_as_asked(102);

  desk.at(50).give(Engage{true, "given back", std::vector{TaskId{100}, TaskId{101}}});

  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101"));
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining[0].id, GoalId{702});
}

/// The ground station has its tasks, and sees one of them abort; then the right to decide comes
/// back, before the tasks do.
Desk given_back_after_a_loss() {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 1"});
  desk.seen(101, TaskState::kScheduled);
  desk.seen(102, TaskState::kAborted, "aborted by the functional layer");
  desk.at(50).give(Engage{true, "given back"});
  return desk;
}

TEST(SupervisorHandOver, WhatAnotherExecutiveHadIsPlannedAnewOnceItIsBack) {
  Desk desk = given_back_after_a_loss();
  EXPECT_THAT(desk.requests(), IsEmpty()) << "nothing is here that could be aborted";
  EXPECT_FALSE(desk.job_started());

  desk.at(50.1).seen(101, TaskState::kScheduled);

  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101"));
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining[0].id, GoalId{702});
}

TEST(SupervisorHandOver, WhatDoesNotComeBackFromAnotherExecutiveIsLost) {
  Desk desk = given_back_after_a_loss();
  ASSERT_EQ(desk.supervisor.next_wakeup(), at(55));

  desk.at(55).give(Tick{});

  EXPECT_THAT(desk.requests(), IsEmpty());
  ASSERT_TRUE(desk.job_started());
  desk.at(56).seen(101, TaskState::kScheduled);
  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101")) << "it comes all the same";
}

TEST(SupervisorHandOver, TheRightToDecideMayGoAgainBeforeWhatWasThereIsBack) {
  Desk desk = given_back_after_a_loss();
  desk.at(51).give(Disengage{"degree 1"});
  desk.seen(101, TaskState::kScheduled);

  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_FALSE(desk.supervisor.next_wakeup().has_value());
}

TEST(SupervisorHandOver, NewTasksWaitForWhatTheGroundHasStarted) {
  Desk desk = under_way();
  desk.at(10).give(Disengage{"degree 3"});
  desk.seen(101, TaskState::kScheduled);
  desk.at(50).give(Engage{false, "degree 4", std::vector{TaskId{100}, TaskId{101}}});
  desk.add(a_mission(2, {703}));

  desk.finish(inserted({703}, {TaskOf(103, "goto", 703).after(100)}));
  desk.at(110).ends(100);

  ASSERT_TRUE(desk.started(103).has_value());
  const executive::Formula waits = desk.started(103)->task.preconditions;
  ASSERT_EQ(waits.size(), 2U);
  EXPECT_EQ(waits[1][0].condition, executive::Condition(executive::TaskInState{TaskId{101}}));
}

// Found by missions of an outsider (247): the vehicle said how the task of that number had ended
// before, and the goal counted as achieved.
TEST(SupervisorLives, OneThatMayHaveLivedBeforeNumbersItsTasksBeyondThoseOfThatLife) {
  Desk first = Desk::engaged(), again = Desk::engaged();
  for (Desk* desk : {&first, &again}) {
    desk->at(477);
    if (desk == &again) desk->give(LivesAgain{});
    desk->add(a_mission(1, {701}));
  }
  EXPECT_EQ(first.insertion().base.situation.next_id, TaskId{100});
  EXPECT_EQ(again.insertion().base.situation.next_id, TaskId{100 + 47'700});
}

// An operator steered by 'go', gave it back, and was refused the next but one: its id was taken.
TEST(SupervisorHandOver, NewTasksAreNumberedBeyondThoseOfOthersButNotBeyondWaysOfWhoSteers) {
  Desk desk = Desk::engaged();
  desk.seen(140, TaskState::kScheduled);
  desk.seen(functional::kFirstSteeringId.value(), TaskState::kScheduled);
  desk.add(a_mission(1, {701}));

  EXPECT_EQ(desk.insertion().base.situation.next_id, TaskId{141});
}

// Found by missions of an outsider (249): its plan waited behind it until its energy was used up.
TEST(SupervisorHandOver, ASafeWaitThatComesBackEndsWhenOrdersCome) {
  Desk desk = under_way();
  desk.give(CancelMission{{{GoalId{701}, GoalId{702}}, {}, true}, "operator"});
  desk.aborted_as_asked(101);
  desk.aborted_as_asked(100);
  desk.flies();
  ASSERT_TRUE(desk.started(103).has_value()) << "the safe wait";
  desk.runs(103);
  desk.at(50).give(Disengage{"degree 1"});

  desk.at(90).give(Engage{true, "degree 4", std::vector<TaskId>{}});
  desk.runs(103);
  desk.flies();
  EXPECT_THAT(desk.requests(), IsEmpty()) << "no other";
  desk.add(a_mission(2, {703}));
  desk.finish(inserted({703}, {TaskOf(110, "goto", 703)}));

  EXPECT_THAT(desk.requests(), Contains("ABORT 103"));
}

TEST(SupervisorHandOver, CancelledMeanwhileTakesWhatDependsOnItToTheGround) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(
      inserted({701, 702}, {TaskOf(100, "goto", 701), TaskOf(101, "goto", 702).after(100)}));
  desk.runs(100);
  desk.at(1).give(Disengage{"degree 3"});
  EXPECT_EQ(desk.state_of(702), "planned");  // the executive has it

  desk.give(CancelMission{{{GoalId{701}}, {}, true}, "operator"});

  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101", "ABORT 100"));
  EXPECT_EQ(desk.state_of(701), "cancelled");
  EXPECT_EQ(desk.state_of(702), "handed-over");
}

}  // namespace
}  // namespace skein::supervisor
