// SPDX-License-Identifier: Apache-2.0
// What happens to a plan: absorbed, shifted, repaired; and the UAV stays safe. Source: spec 6.2
// (6).
#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// ---- world, devices, energy ----

WorldChanged closed(std::string name, world::Polygon polygon, world::TimeWindow when = {}) {
  return {{{std::move(name), std::move(polygon), 0, 100, when}, false}};
}
const world::Polygon kAhead{{200, -50}, {300, -50}, {300, 50}, {200, 50}};
const world::Polygon kBehind{{-300, -50}, {-200, -50}, {-200, 50}, {-300, 50}};
const world::Polygon kOnPlanned{{400, 200}, {600, 200}, {600, 300}, {400, 300}};

TEST(SupervisorWorld, ClosedAheadStopsWhatFliesThere) {
  Desk desk = flying();

  desk.at(30).give(closed("fire", kAhead));

  EXPECT_TRUE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101", "START 103"));
  EXPECT_EQ(desk.repair().failed->id, GoalId{701});
  EXPECT_EQ(desk.repair().base.world->volumes.size(), 1U);
}

TEST(SupervisorWorld, ClosedWhereItHasBeenOrBeforeItComesStopsNothing) {
  Desk desk = flying();
  desk.flies({350, 0, 40});

  desk.at(60).give(closed("passed", kAhead));
  EXPECT_FALSE(desk.job_started());
  desk.give(closed("elsewhere", kBehind));
  EXPECT_FALSE(desk.job_started());
  desk.give(closed("short", kOnPlanned, {at(60), at(90)}));
  EXPECT_FALSE(desk.job_started());
}

TEST(SupervisorWorld, ClosedOnAPlannedWayMakesThatPlannedAnewOnly) {
  Desk desk = flying();

  desk.at(30).give(closed("fire", kOnPlanned));

  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_EQ(desk.repair().failed->id, GoalId{702});
  EXPECT_EQ(desk.repair().standing.tasks.size(), 1U);
}

TEST(SupervisorWorld, MadeOfNonsenseIsRefused) {
  Desk desk = flying();

  desk.give(closed("", {{0, 0}}));
  EXPECT_EQ(desk.of<Answer>()[0].reasons.size(), 2U);
  desk.give(WorldChanged{{{"never closed", {}, 0, 1, {}}, true}});
  EXPECT_FALSE(desk.of<Answer>()[0].accepted);
}

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

// As flying(), with goal 703 (goto 103) at the end.
Desk flying_far() {
  Desk desk = flying();
  desk.add(a_mission(2, {703}));
  desk.finish(inserted({702, 703}, {TaskOf(103, "goto", 702).after(101).energy(0.1),
                                    TaskOf(104, "goto", 703).after(103).energy(0.05)}));
  return desk;
}

TEST(SupervisorEnergy, ThatRunsShortIsToldOnceAndRepaired) {
  Desk desk = flying_far();
  desk.at(6).flies({0, 0, 40}, 0.455);
  EXPECT_FALSE(desk.job_started());

  desk.at(7).flies({0, 0, 40}, 0.44);

  ASSERT_TRUE(desk.job_started());
  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_FALSE(desk.repair().failed.has_value());
  EXPECT_EQ(desk.repair().remaining.size(), 2U);
  desk.flies({0, 0, 40}, 0.385);
  EXPECT_FALSE(desk.job_started());
}

TEST(SupervisorEnergy, ThatIsNotEnoughForTheEndOfThePlanEndsWhatIsUnderWay) {
  Desk desk = flying_far();

  desk.at(7).flies({0, 0, 40}, 0.34);

  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101", "START 105"));
  EXPECT_EQ(desk.repair().failed->id, GoalId{701});
  EXPECT_FALSE(desk.repair().refine_failed);
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
  desk.seen(100, TaskState::kAborted, "abort requested");

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
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("nothing to do")));
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
  EXPECT_THAT(desk.notices(), ElementsAre("in the air without a task"));
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
  desk.seen(101, TaskState::kAborted, "abort requested");
  desk.seen(103, TaskState::kAborted, "rejected", "wait");
  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("refused or aborted")));
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(10));

  desk.at(10).give(Tick{});

  EXPECT_THAT(desk.requests(), ElementsAre("START 104"));
}

TEST(SupervisorSafety, WaitsForWhatOthersFly) {
  Desk desk = Desk::engaged();
  desk.seen(7, TaskState::kScheduled, "", "goto");
  desk.seen(7, TaskState::kStarted, "", "goto");
  desk.add(a_mission(1, {701}));
  EXPECT_EQ(desk.insertion().base.situation.motion.after,
            (mission::Dependence{mission::DependenceKind::kOver, TaskId{7}}));

  desk.finish(inserted({701}, {TaskOf(100, "goto", 701)}));

  ASSERT_EQ(desk.started(100)->task.preconditions.size(), 1U);
  EXPECT_EQ(desk.started(100)->task.preconditions[0][0].condition,
            executive::Condition(executive::TaskInState{TaskId{7}}));
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

}  // namespace
}  // namespace skein::supervisor
