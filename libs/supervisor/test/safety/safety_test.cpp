// SPDX-License-Identifier: Apache-2.0
// What happens to a plan: absorbed, shifted, repaired; and the UAV stays safe. Source: spec 6.2
// (6).
#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

// ---- devices ----

TEST(SupervisorDevices, ThatFailMakeThePlansThatNeedThemFail) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted({701, 702}, {TaskOf(100, "goto", 701).takes(100, 110),
                                    TaskOf(101, "takeshot", 702).after(100).device("camera")}));
  desk.runs(100);

  desk.flies({0, 0, 40}, 1, {"camera"});

  EXPECT_EQ(desk.repair().failed->id, GoalId{702});
  EXPECT_THAT(desk.repair().base.situation.broken, ElementsAre("camera"));
  EXPECT_THAT(desk.requests(), IsEmpty());
}

// ---- waits and stops ----

TEST(SupervisorWait, ForOrdersEndsWhenTheNextTaskComesAndCountsAsAchieved) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "wait", 701).until_orders()}));
  desk.runs(100);
  desk.flies();
  desk.at(30).add(a_mission(2, {702}));
  EXPECT_EQ(desk.insertion().base.situation.motion.after,
            (mission::Dependence{mission::DependenceKind::kOver, TaskId{100}}));

  desk.at(31).finish(inserted({702}, {TaskOf(101, "goto", 702).over(100)}));
  EXPECT_THAT(desk.requests(), ElementsAre("START 101", "ABORT 100"));
  desk.aborted_as_asked(100);

  EXPECT_EQ(desk.state_of(701), "achieved");
  EXPECT_FALSE(desk.job_started());
}

TEST(SupervisorWait, ForOrdersThatHasNotBegunKeepsWhatComesBehindIt) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted(
      {701, 702}, {TaskOf(100, "goto", 701), TaskOf(101, "wait", 701).after(100).until_orders(),
                   TaskOf(102, "goto", 702).over(101)}));
  EXPECT_THAT(desk.requests(), ElementsAre("START 100", "START 101"));
  desk.runs(100);
  desk.at(15).ends(100);
  EXPECT_THAT(desk.requests(), IsEmpty());

  desk.runs(101);

  EXPECT_TRUE(desk.started(102).has_value());
}

TEST(SupervisorStop, OfATakeshotWhenItsMotionEndedIsAsItShouldBe) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "wait", 701).takes(20, 20),
                               TaskOf(101, "takeshot", 701).during(100).stopped_by(100)}));
  desk.runs(100);
  desk.runs(101);
  desk.at(20).ends(100);
  EXPECT_EQ(desk.state_of(701), "under-way");

  desk.seen(101, TaskState::kAborting, "exit conditions satisfied", "takeshot");
  desk.aborted(101, "stopped");

  EXPECT_EQ(desk.state_of(701), "achieved");
}

TEST(SupervisorStop, ByALaterTaskComesAsAnUpdateOfConditions) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));

  desk.finish(inserted(
      {701}, {TaskOf(100, "wait", 701).stopped_by(101), TaskOf(101, "goto", 701).during(100)}));

  EXPECT_THAT(desk.requests(), ElementsAre("START 100", "START 101", "UPDATE 100"));
}

// ---- safety ----

TEST(SupervisorSafety, WaitsWhenThePlanEndsInTheAir) {
  Desk desk = flying();
  desk.at(110).ends(101);
  desk.runs(102);

  desk.at(165).ends(102);

  EXPECT_THAT(desk.requests(), ElementsAre("START 103"));
  EXPECT_THAT(desk.notices(),
              Contains(AllOf(HasSubstr("nothing to do"),
                             HasSubstr("nothing follows goal 702 (go 1), achieved"))));
}

TEST(SupervisorSafety, APerceptionAtTheEndOfAWayIsATask) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "takeoff", 701).takes(4, 6),
                               TaskOf(101, "goto", 701).after(100).takes(100, 120),
                               TaskOf(102, "takeshot", 701).after(101).takes(20, 20)}));
  desk.runs(100);
  desk.at(5).ends(100);
  desk.runs(101);
  desk.flies();

  desk.at(110).ends(101);  // the executive starts 102 in the same step, and tells so next

  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_THAT(desk.notices(), IsEmpty());
  desk.runs(102);
  EXPECT_THAT(desk.requests(), IsEmpty());
  desk.at(131).ends(102);
  EXPECT_THAT(desk.requests(), ElementsAre("START 103"));
}

TEST(SupervisorSafety, OnlySaysSoBeforeItsFirstTask) {
  Desk desk = Desk::engaged();

  desk.flies();

  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_THAT(desk.notices(), ElementsAre("in the air without a task: no mission was given to it"));
  desk.flies();
  EXPECT_THAT(desk.notices(), IsEmpty());
}

TEST(SupervisorSafety, DoesNotWaitOnTheGroundAfterALanding) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "land", 701)}));
  desk.flies();
  desk.runs(100);
  desk.at(15).ends(100);
  EXPECT_THAT(desk.requests(), IsEmpty());

  desk.at(15.5).flies();

  EXPECT_THAT(desk.requests(), IsEmpty());
}

TEST(SupervisorSafety, TriesARefusedWaitAgainLater) {
  Desk desk = flying();
  desk.give(CancelMission{{}, "operator"});
  desk.aborted_as_asked(101);
  desk.seen(103, TaskState::kAborted, "rejected", "wait");
  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("refused or aborted")));
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(10));

  desk.at(10).give(Tick{});

  EXPECT_THAT(desk.requests(), ElementsAre("START 104"));
}

// Found by random missions (--hands 2459): its way began where the UAV had been when it was
// planned, and led through closed air.
TEST(SupervisorSafety, WaitsForWhatOthersFlyAndPlansAnewFromWhereThatHasLedIt) {
  Desk desk = Desk::engaged();
  desk.seen(7, TaskState::kScheduled, "", "goto");
  desk.seen(7, TaskState::kStarted, "", "goto");
  desk.add(a_mission(1, {701}));
  EXPECT_EQ(desk.insertion().base.situation.motion.after,
            (mission::Dependence{mission::DependenceKind::kOver, TaskId{7}}));
  desk.finish(inserted({701}, {TaskOf(100, "goto", 701)}));
  EXPECT_THAT(desk.requests(), IsEmpty());

  desk.seen(7, TaskState::kEnded, "", "goto");

  EXPECT_THAT(desk.repair().remaining, SizeIs(1));
  desk.finish(repaired(RepairStep::kReplan, {701}, {TaskOf(101, "goto", 701)}));
  EXPECT_THAT(desk.requests(), ElementsAre("START 101"));
}

// Likewise (--hands 7344): the last of them never began.
TEST(SupervisorSafety, PlansAnewOnceTheLastOfWhatOthersFlyIsOver) {
  Desk desk = Desk::engaged();
  desk.seen(7, TaskState::kScheduled, "", "goto");
  desk.seen(7, TaskState::kStarted, "", "goto");
  desk.seen(8, TaskState::kScheduled, "", "land");
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "goto", 701)}));
  desk.seen(7, TaskState::kEnded, "", "goto");
  EXPECT_THAT(desk.requests(), IsEmpty());

  desk.seen(8, TaskState::kAborted, "the preconditions are false for ever", "land");

  EXPECT_THAT(desk.repair().remaining, SizeIs(1));
  EXPECT_THAT(desk.requests(), IsEmpty());
}

// ---- joint tasks ----

TEST(SupervisorJoint, IsLoadedWhenGivenAndAbortedWhenItCannotBe) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "joint:track", 701)}));
  ASSERT_EQ(desk.of<LoadJointTask>().size(), 1U);
  EXPECT_FALSE(desk.of<LoadJointTask>()[0].preferences.empty());
  EXPECT_THAT(desk.decisions(), Contains("4 load joint task"));

  desk.give(JointTaskDue{TaskId{100}, false});
  EXPECT_THAT(desk.requests(), IsEmpty());
  desk.give(JointTaskAnswered{TaskId{100}, false, {}, "no interaction manager"});
  EXPECT_THAT(desk.requests(), ElementsAre("STATUS 100"));

  desk.seen(100, TaskState::kAborted, "no interaction manager", "joint:track");
  EXPECT_EQ(desk.repair().failed->id, GoalId{701});
}

TEST(SupervisorJoint, AgreedIntervalBecomesItsConditions) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "joint:track", 701)}));

  desk.give(JointTaskAnswered{TaskId{100}, true, {secs(50), secs(60)}, ""});

  EXPECT_THAT(desk.requests(), ElementsAre("UPDATE 100"));
  EXPECT_EQ(desk.supervisor.report().tasks[0].dates.earliest_start, at(50));
}

TEST(SupervisorJoint, WhatItsRoleTakesCountsInThePlan) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "joint:track", 701)}));
  const Duration longest = desk.supervisor.report().tasks[0].task.duration.most;

  desk.give(JointTaskAnswered{TaskId{100},
                              true,
                              {secs(50), secs(60)},
                              "",
                              JointTaskAnswered::Takes{longest + secs(100), 0.25}});

  const mission::ElementaryTask& task = desk.supervisor.report().tasks[0].task;
  EXPECT_EQ(task.energy, 0.25);
  EXPECT_EQ(task.duration.most, longest + secs(100));
}

// Each would wait for the other for ever.
TEST(SupervisorJoint, ToldAgainItDoesNotWaitForTheWaitForOrdersBehindIt) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "joint:track", 701),
                               TaskOf(101, "wait", 701).after(100).until_orders()}));

  desk.give(JointTaskAnswered{TaskId{100}, true, {secs(50), secs(60)}, ""});

  const auto sent = desk.of<ToExecutive>();
  ASSERT_EQ(sent.size(), 1U);
  const auto& update = std::get<executive::UpdateConditions>(sent[0].input);
  EXPECT_EQ(update.id, TaskId{100});
  for (const executive::Clause& clause : update.preconditions.value()) {
    for (const executive::Literal& literal : clause)
      EXPECT_FALSE(std::holds_alternative<executive::TaskInState>(literal.condition));
  }
}

}  // namespace
}  // namespace skein::supervisor
