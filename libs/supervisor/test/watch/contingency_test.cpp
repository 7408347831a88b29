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

std::string cause_of(const Desk& desk) { return desk.of<Decided>().front().decision.cause; }

// ---- the first two rungs ----

TEST(SupervisorDates, WithinWhatWasPromisedAreNoDecision) {
  Desk desk = flying();

  desk.at(110).ends(101);

  EXPECT_THAT(desk.decisions(), Not(Contains(HasSubstr("6 repair"))));
  EXPECT_EQ(desk.supervisor.report().tasks[0].dates.earliest_start, at(110));
}

TEST(SupervisorDates, OfATaskThatTakesTooLongAreShifted) {
  Desk desk = flying();
  desk.at(90).give(Tick{});
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(126));

  desk.at(126).give(Tick{});

  EXPECT_THAT(desk.decisions(), ElementsAre("6 repair: shift"));
  EXPECT_EQ(cause_of(desk), "task 101 overdue by 1 s");
  desk.at(127).give(Tick{});
  EXPECT_THAT(desk.decisions(), IsEmpty());
}

TEST(SupervisorDates, OfATaskThatIsDoneEarlyAreShifted) {
  Desk desk = flying();

  desk.at(50).ends(101);

  EXPECT_THAT(desk.decisions(), Contains("6 repair: shift"));
  EXPECT_EQ(cause_of(desk), "task 101 early by 55 s");
}

TEST(SupervisorDates, ThatBreakTheNetworkMakeARepairOfTheGoalThatSuffers) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(
      inserted({701, 702}, {TaskOf(100, "goto", 701).takes(100, 110),
                            TaskOf(101, "goto", 702).after(100).takes(50, 60).ends_before(175)}));
  desk.runs(100);

  desk.at(111).give(Tick{});
  EXPECT_THAT(desk.decisions(), Contains("6 repair: shift"));
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(115.001));

  desk.at(115.001).give(Tick{});

  ASSERT_TRUE(desk.job_started());
  ASSERT_TRUE(desk.repair().failed.has_value());
  EXPECT_EQ(desk.repair().failed->id, GoalId{702});
}

// ---- failures ----

TEST(SupervisorRepair, RefinesTheGoalOfATaskThatFailedAndWaitsMeanwhile) {
  Desk desk = flying();

  desk.at(30).aborted(101, "engine trouble");

  EXPECT_THAT(desk.requests(), ElementsAre("START 103"));
  EXPECT_EQ(desk.started(103)->task.type, "wait");
  EXPECT_EQ(desk.started(103)->mode, executive::InsertionMode::kVut);
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("safe mode")));
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().failed->id, GoalId{701});
  EXPECT_TRUE(desk.repair().refine_failed);
  EXPECT_EQ(desk.repair().failed_at, 0U);
  ASSERT_EQ(desk.repair().remaining.size(), 1U);
  EXPECT_EQ(desk.state_of(701), "under-way");
}

TEST(SupervisorRepair, GivesTheNewPlanAndEndsTheSafeWait) {
  Desk desk = flying();
  desk.at(30).aborted(101);

  desk.at(31).finish(
      repaired(RepairStep::kRefine, {701, 702},
               {TaskOf(104, "goto", 701).takes(50, 60), TaskOf(105, "goto", 702).after(104)}));

  EXPECT_THAT(desk.requests(), ElementsAre("START 104", "ABORT 103"));
  const executive::Formula waits_of = desk.started(104)->task.preconditions;
  ASSERT_EQ(waits_of.size(), 1U);
  const executive::Literal& over = waits_of[0][0];
  EXPECT_EQ(over.condition, executive::Condition(executive::TaskInState{TaskId{103}}));
  EXPECT_EQ(over.modality, executive::Modality::kOptional);
  EXPECT_THAT(desk.decisions(), Contains("6 repair: re-refine"));
}

TEST(SupervisorRepair, RefinesAGoalOnlySoOften) {
  Config config = config_for_tests();
  config.refinements = 1;
  Desk desk = Desk::engaged(config);
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "goto", 701)}));
  desk.runs(100);
  desk.aborted(100);
  EXPECT_TRUE(desk.repair().refine_failed);
  desk.finish(repaired(RepairStep::kRefine, {701}, {TaskOf(101, "goto", 701)}));
  desk.runs(101);

  desk.aborted(101);

  EXPECT_FALSE(desk.repair().refine_failed);
}

TEST(SupervisorRepair, DroppedGoalsFailWithTheReason) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701, 702}));
  desk.finish(
      inserted({701, 702}, {TaskOf(100, "goto", 701), TaskOf(101, "goto", 702).after(100)}));
  desk.runs(100);
  desk.aborted(100);
  RepairOutcome outcome = repaired(RepairStep::kDrop, {702}, {TaskOf(102, "goto", 702)});
  outcome.dropped = {{GoalId{701}, "no way"}};

  desk.finish(outcome);

  EXPECT_EQ(desk.state_of(701), "failed");
  EXPECT_EQ(desk.why_of(701), "the goto of goal 701 (go 1) aborted: engine trouble; no way");
  EXPECT_THAT(desk.requests(), ElementsAre("START 102"));
  EXPECT_THAT(desk.decisions(), Contains("6 repair: drop"));
}

TEST(SupervisorRepair, ThatFindsNothingFailsIntoSafeMode) {
  Desk desk = flying();
  desk.at(30).aborted(101);
  RepairOutcome nothing;
  nothing.before = {"re-refine: no way"};

  desk.finish(nothing);

  EXPECT_EQ(desk.state_of(701), "failed");
  EXPECT_EQ(desk.state_of(702), "failed");
  EXPECT_THAT(desk.decisions(), ElementsAre("6 repair: fail"));
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("the mission has failed, safe mode")));
  EXPECT_THAT(desk.requests(), IsEmpty());  // it waits already, task 103
}

TEST(SupervisorRepair, StopsWhatDependsOnTheFailedTaskTheHighestIdFirst) {
  Desk desk = flying();
  desk.at(95).give(Tick{});  // 702 is with the executive now

  desk.at(96).aborted(101);

  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 102", "START 103"));
  desk.seen(102, TaskState::kAborted, "the preconditions are false for ever");
  EXPECT_THAT(desk.decisions(), IsEmpty());
  EXPECT_EQ(desk.state_of(702), "planned");
}

TEST(SupervisorRepair, TakesARefusedStartForAFailure) {
  Desk desk = flying();
  desk.at(95).give(Tick{});

  desk.give(RequestAnswered{{executive::RequestKind::kStart, TaskId{102}, false, "id is known"}});

  EXPECT_EQ(desk.repair().failed->id, GoalId{702});
  EXPECT_EQ(desk.repair().standing.tasks.size(), 1U);
}

TEST(SupervisorRepair, OfAFailureDuringItsJobIsMadeAgain) {
  Desk desk = flying();
  desk.at(95).give(Tick{});
  desk.give(RequestAnswered{{executive::RequestKind::kStart, TaskId{102}, false, "id is known"}});
  const std::uint64_t first = desk.job_id;
  desk.at(96).aborted(101);

  desk.finish(repaired(RepairStep::kRefine, {702}, {TaskOf(103, "goto", 702).after(101)}));

  EXPECT_NE(desk.job_id, first);
  EXPECT_FALSE(desk.started(103) && desk.started(103)->task.type == "goto");
}

// ---- orders of people at the executive ----

TEST(SupervisorCancel, FollowsAnAbortAtTheExecutiveThatItDidNotAskFor) {
  Desk desk = flying();
  desk.at(30).aborting_as_asked(101);
  desk.seen(101, TaskState::kAborted, "stopped");

  EXPECT_EQ(desk.state_of(701), "cancelled");
  EXPECT_THAT(desk.decisions(), Contains("2 cancel"));
  ASSERT_TRUE(desk.job_started());
  EXPECT_FALSE(desk.repair().failed.has_value());
  EXPECT_FALSE(desk.repair().refine_failed);
  EXPECT_EQ(desk.repair().remaining[0].id, GoalId{702});
}

TEST(SupervisorCancel, DoesNotFollowAVehicleThatAbortsInTheWordsOfARequest) {
  Desk desk = flying();

  desk.at(30).aborted(101, "abort requested");

  EXPECT_NE(desk.state_of(701), "cancelled");
  ASSERT_TRUE(desk.job_started());
  EXPECT_TRUE(desk.repair().failed.has_value());
}

TEST(SupervisorCancel, OfTheLastPlannedGoalNeedsNoPlanning) {
  Desk desk = flying();

  desk.give(CancelMission{{{GoalId{702}}, {}, true}, "operator"});

  EXPECT_EQ(desk.state_of(702), "cancelled");
  EXPECT_FALSE(desk.job_started());
  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_EQ(desk.supervisor.report().tasks.size(), 2U);
}

TEST(SupervisorCancel, OfEverythingInTheAirStopsAndWaits) {
  Desk desk = flying();

  desk.give(CancelMission{{}, "operator"});

  EXPECT_TRUE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101", "START 103"));
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("safe mode")));
  EXPECT_EQ(desk.state_of(701), "cancelled");
}

TEST(SupervisorCancel, WithoutInterruptLeavesWhatIsUnderWay) {
  Desk desk = flying();

  desk.give(CancelMission{{{}, {}, false}, "operator"});

  EXPECT_EQ(desk.state_of(701), "under-way");
  EXPECT_EQ(desk.state_of(702), "cancelled");
  EXPECT_THAT(desk.requests(), IsEmpty());
}

TEST(SupervisorCancel, OfWhatIsNotKnownIsRefused) {
  Desk desk = flying();

  desk.give(CancelMission{{{GoalId{9}, GoalId{701}}, {}, true}, "operator"});

  EXPECT_FALSE(desk.of<Answer>()[0].accepted);
  EXPECT_EQ(desk.state_of(701), "under-way");
}

TEST(SupervisorCancel, OfAMissionThatWaitsIsToldAsNotPlanned) {
  Desk desk = Desk::engaged();
  desk.add(a_mission(1, {701}));
  desk.give(CancelMission{{{}, mission::MissionId{1}, true}, "operator"});
  ASSERT_EQ(desk.of<MissionDecided>().size(), 1U);
  EXPECT_FALSE(desk.of<MissionDecided>()[0].outcome.planned);

  desk.finish(inserted({701}, {TaskOf(100, "goto", 701)}));

  EXPECT_EQ(desk.state_of(701), "cancelled");
  EXPECT_THAT(desk.requests(), IsEmpty());
}

/// The way to a look is flown; then a task that is not the plan's leads the vehicle there, and the
/// look begins.
bool is_planned_again_at(const world::Vector3& where) {
  Desk desk = Desk::engaged();
  desk.flies();
  desk.add(a_mission(1, {701}));
  desk.finish(inserted(
      {701}, {TaskOf(100, "goto", 701).way({{0, 0, 40}, {500, 0, 40}}),
              TaskOf(101, "takeshot", 701).after(100).device("camera").target({500, 0, 0})}));
  desk.runs(100);
  desk.flies({500, 0, 40});
  desk.ends(100);
  const std::uint64_t home = 1'000'372'371;
  desk.seen(home, TaskState::kRunning);
  desk.seen(home, TaskState::kAborted);
  desk.flies(where);
  desk.seen(101, TaskState::kStarted, "", "takeshot");
  return desk.job_started();
}

// Found by random missions (--anything --merged 994001): a robot that was on its way home out of
// contact was given back, and perceived for 66 s from where it was.
TEST(Contingencies, ALookIsNotDoneFromWhereAnotherTaskHasLedTheVehicle) {
  EXPECT_TRUE(is_planned_again_at({200, 0, 40}));
  EXPECT_FALSE(is_planned_again_at({490, 0, 40}));
}

}  // namespace
}  // namespace skein::supervisor
