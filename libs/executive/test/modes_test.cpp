// SPDX-License-Identifier: Apache-2.0
// The four modes of insertion. Source: spec 2.3.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/mission.hpp"

namespace skein::executive {
namespace {

using testing::ce;
using testing::cm;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Mission;
using testing::optional;
using testing::TaskOf;
using enum TaskState;
using enum InsertionMode;

Literal ended(std::uint64_t id) { return ce(id, kEnded); }

// --- DEP, NUT ---

TEST(InsertionMode, DepFollowsTheEndOfEveryTaskNotYetTerminal) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "goto").pre({cm("go")}));
  mission.start(TaskOf(3, "takeshot"));
  mission.ends(3);

  mission.start(TaskOf(4, "land").pre({cm("ignored")}).exit({cm("stop")}), kDep);

  EXPECT_EQ(mission.executive.preconditions(TaskId{4}), (Formula{{ended(1)}, {ended(2)}}));
  EXPECT_EQ(mission.executive.exit_conditions(TaskId{4}), (Formula{{cm("stop")}}));
}

TEST(InsertionMode, NutIsTheSameWithOptionalConditions) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));

  mission.start(TaskOf(2, "land").exit({cm("stop")}), kNut);

  EXPECT_EQ(mission.executive.preconditions(TaskId{2}), (Formula{{optional(ended(1))}}));
  EXPECT_EQ(mission.executive.exit_conditions(TaskId{2}), (Formula{{cm("stop")}}));
}

TEST(InsertionMode, DepAndNutGoAtOnceWhenNothingIsLeft) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(1, "goto"), kDep),
              ElementsAre("1 scheduled", "1 started", "dispatch 1"));
  mission.ends(1);
  EXPECT_THAT(mission.start(TaskOf(2, "goto"), kNut),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
}

// --- what is done for want of anything else ---

Mission waiting(const Task& wait = TaskOf(1, "wait")) {
  Config config = testing::named("marvin");
  config.idle_type = "wait";
  Mission mission(config);
  mission.start(wait);
  mission.runs(1);
  return mission;
}
const testing::Words kGivesWay{"2 scheduled", "1 aborting", "interrupt 1", "2 started",
                               "dispatch 2"};

TEST(IdleTask, IsNotWaitedForByDepAndNutAndGivesWay) {
  EXPECT_EQ(waiting().start(TaskOf(2, "goto"), kDep), kGivesWay);
  EXPECT_EQ(waiting().start(TaskOf(2, "goto"), kNut), kGivesWay);
  EXPECT_EQ(waiting().start(TaskOf(2, "goto")), kGivesWay);
}

TEST(IdleTask, GivesWayWhenWhatComesIsDueAndNotBefore) {
  Mission mission = waiting();
  EXPECT_THAT(mission.start(TaskOf(2, "goto").pre({cm("go")})), ElementsAre("2 scheduled"));
  EXPECT_THAT(mission.message("go"),
              ElementsAre("1 aborting", "interrupt 1", "2 started", "dispatch 2"));
  EXPECT_EQ(mission.reason_of(1), "gives way to task 2");
}

TEST(IdleTask, StaysBesideWhatNeedsNothingOfIt) {
  EXPECT_THAT(waiting().start(TaskOf(2, "takeshot").device("visible"), kDep),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
}

TEST(IdleTask, IsSeenToGiveWay) {
  Mission mission = waiting();
  mission.start(TaskOf(2, "takeshot"));

  EXPECT_TRUE(mission.executive.find(TaskId{1})->gives_way);
  EXPECT_FALSE(mission.executive.find(TaskId{2})->gives_way);
  mission.update(1, std::nullopt, Formula{{cm("stop")}});
  EXPECT_FALSE(mission.executive.find(TaskId{1})->gives_way) << "it has an end now";
}

TEST(IdleTask, IsNoneThatEndsByItselfOrHasNotBegun) {
  Task lasts = TaskOf(1, "wait");
  lasts.parameters.add(Parameter{"duration", {}, {20}});
  const Task stopped = TaskOf(1, "wait").exit({cm("stop")});
  EXPECT_THAT(waiting(lasts).start(TaskOf(2, "goto"), kDep), ElementsAre("2 scheduled"));
  EXPECT_THAT(waiting(stopped).start(TaskOf(2, "goto"), kDep), ElementsAre("2 scheduled"));
  EXPECT_THAT(waiting(TaskOf(1, "wait").pre({cm("go")})).start(TaskOf(2, "goto"), kDep),
              ElementsAre("2 scheduled"));
  Mission without;
  without.start(TaskOf(1, "wait"));
  EXPECT_THAT(without.start(TaskOf(2, "goto"), kDep), ElementsAre("2 scheduled"));
}

TEST(InsertionMode, DepFallsWithItsPredecessorAndNutSurvivesIt) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "goto"), kDep);
  mission.start(TaskOf(3, "land"), kNut);

  mission.abort(1);

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", "2 aborted", "3 started", "dispatch 3"));
}

TEST(InsertionMode, ASuccessorNeverStartsWhileItsPredecessorIsAborting) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "land"), kNut);

  EXPECT_THAT(mission.abort(1), ElementsAre("1 aborting", "interrupt 1"));
  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", "2 started", "dispatch 2"));
}

TEST(InsertionMode, DepAndNutWaitForATaskThatIsAborting) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.abort(1);

  EXPECT_THAT(mission.start(TaskOf(2, "goto"), kDep), ElementsAre("2 scheduled"));
  EXPECT_THAT(mission.start(TaskOf(3, "takeshot"), kNut), ElementsAre("3 scheduled"));
}

// --- VUT ---

TEST(InsertionMode, VutGoesAtOnceAndIgnoresItsPreconditions) {
  Mission mission;
  mission.start(TaskOf(1, "takeshot"));

  EXPECT_THAT(mission.start(TaskOf(2, "goto").pre({cm("never said")}), kVut),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
}

TEST(InsertionMode, VutDoesNotEvenLookAtWhatItsPreconditionsName) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(2, "goto").pre({ended(99)}), kVut),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
}

TEST(InsertionMode, VutKeepsItsExitConditionsAndTheirCoherence) {
  Mission mission;
  mission.start(TaskOf(1, "goto").exit({cm("stop")}), kVut);

  EXPECT_THAT(mission.message("stop"), ElementsAre("1 aborting", "interrupt 1"));
  EXPECT_THAT(mission.start(TaskOf(2, "takeshot").exit({cm("stop")}), kVut),
              ElementsAre("2 aborted"));
}

TEST(InsertionMode, VutIsScheduledThenInterruptsWhatIsIncompatibleById) {
  Mission mission;
  mission.start(TaskOf(5, "goto"));
  mission.start(TaskOf(3, "wait"));
  mission.runs(3);
  mission.start(TaskOf(4, "takeshot").device("camera"));

  EXPECT_THAT(mission.start(TaskOf(9, "land"), kVut),
              ElementsAre("9 scheduled", "3 aborting", "interrupt 3", "5 aborting", "interrupt 5"));
}

TEST(InsertionMode, VutWaitsUntilAllThatIsIncompatibleIsTerminal) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "wait"));
  mission.start(TaskOf(3, "land"), kVut);

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.ends(2), ElementsAre("2 aborted", "3 started", "dispatch 3"));
}

TEST(InsertionMode, VutWaitsForATaskAlreadyAbortingWithoutInterruptingItAgain) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.abort(1);

  EXPECT_THAT(mission.start(TaskOf(2, "land"), kVut), ElementsAre("2 scheduled"));
  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", "2 started", "dispatch 2"));
}

TEST(InsertionMode, VutLeavesAloneWhatIsOnlyScheduled) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go")}));

  EXPECT_THAT(mission.start(TaskOf(2, "land"), kVut),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
  EXPECT_EQ(mission.state_of(1), kScheduled);
}

TEST(InsertionMode, VutGoesAheadOfTasksWithALowerId) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot").pre({optional(ended(1))}));
  mission.start(TaskOf(3, "land"), kVut);

  EXPECT_THAT(mission.aborted(1),
              ElementsAre("1 aborted", "3 started", "dispatch 3", "2 started", "dispatch 2"));
}

TEST(InsertionMode, VutGoesAfterABoundedWaitAndSaysSo) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "land"), kVut);

  EXPECT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(10));
  EXPECT_THAT(mission.at(9.9).tick(), IsEmpty());
  EXPECT_THAT(mission.at(10).tick(), ElementsAre("2 started", "dispatch 2"));
  EXPECT_THAT(mission.notices, ElementsAre(HasSubstr("urgent task 2 goes after 10")));
  EXPECT_EQ(mission.state_of(1), kAborting);
}

TEST(InsertionMode, TheLateConfirmationOfABlockerDoesNotDispatchTheUrgentTaskAgain) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "land"), kVut);
  mission.at(10).tick();

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted"));
}

TEST(InsertionMode, AWaitingVutCanBeCancelled) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "land").exit({cm("stop")}), kVut);

  EXPECT_THAT(mission.message("stop"), ElementsAre("2 aborted"));
  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted"));
  EXPECT_EQ(mission.executive.next_wakeup(), std::nullopt);
}

TEST(InsertionMode, AWaitingVutTakesNoPreconditionsButTakesExitConditions) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "land"), kVut);

  EXPECT_THAT(mission.update(2, Formula{}, {}), ElementsAre("refused UPDATE-COND"));
  EXPECT_THAT(mission.update(2, {}, Formula{{cm("stop")}}), IsEmpty());
  EXPECT_THAT(mission.message("stop"), ElementsAre("2 aborted"));
}

TEST(InsertionMode, TwoUrgentTasksGoByIdWhenTheSameTaskFreesThem) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(4, "land"), kVut);
  mission.start(TaskOf(2, "wait"), kVut);

  EXPECT_THAT(mission.aborted(1),
              ElementsAre("1 aborted", "2 started", "dispatch 2", "4 started", "dispatch 4"));
}

// --- urgent ones that wait together ---

Mission where_the_last_counts() {
  Config config = testing::named("marvin");
  config.last_urgent_counts = true;
  return Mission(config);
}

// Found by an outsider's missions over DDS, in which an operator changed his mind during a cut:
// each was dispatched once the first flight was over, and the vehicle took one of them.
TEST(LastUrgent, TakesThePlaceOfOneThatStillWaits) {
  Mission mission = where_the_last_counts();
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(5, "land"), kVut);

  EXPECT_THAT(mission.start(TaskOf(3, "goto"), kVut), ElementsAre("3 scheduled", "5 aborted"));
  EXPECT_EQ(mission.reason_of(5), "urgent task 3 takes its place");
  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", "3 started", "dispatch 3"));
}

TEST(LastUrgent, TakesItBeforeItInterruptsWhatIsUnderWay) {
  Mission mission = where_the_last_counts();
  mission.start(TaskOf(1, "takeshot").device("camera"));
  mission.start(TaskOf(2, "perceive").device("camera"), kVut);
  mission.start(TaskOf(3, "goto"));

  EXPECT_THAT(mission.start(TaskOf(4, "land"), kVut),
              ElementsAre("4 scheduled", "2 aborted", "3 aborting", "interrupt 3"));
}

TEST(LastUrgent, LeavesWhatNeedsNothingOfItAndWhatIsNotUrgent) {
  Mission mission = where_the_last_counts();
  mission.start(TaskOf(1, "takeshot").device("camera"));
  mission.start(TaskOf(2, "takeshot").device("camera"), kVut);
  mission.start(TaskOf(3, "goto").pre({cm("go")}));

  EXPECT_THAT(mission.start(TaskOf(4, "land"), kVut),
              ElementsAre("4 scheduled", "4 started", "dispatch 4"));
  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", "2 started", "dispatch 2"));
  EXPECT_EQ(mission.state_of(3), kScheduled);
}

// --- incompatibility (spec 2.5) ---

TEST(InsertionMode, TwoShotsAreIncompatibleExactlyOnTheSameDevice) {
  Mission mission;
  mission.start(TaskOf(1, "takeshot").device("camera"));
  mission.start(TaskOf(2, "takeshot").device("infrared"));

  EXPECT_THAT(mission.start(TaskOf(3, "takeshot").device("infrared"), kVut),
              ElementsAre("3 scheduled", "2 aborting", "interrupt 2"));
}

TEST(InsertionMode, SynchronisationsAndJointTasksAreCompatibleWithAll) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "joint:track"));

  EXPECT_THAT(mission.start(TaskOf(3, "joint:survey"), kVut),
              ElementsAre("3 scheduled", "forward 3 scheduled", "3 started", "forward 3 started",
                          "dispatch joint 3"));
}

TEST(InsertionMode, IncompatibilityComesFromTheDeclaredResources) {
  Config config = testing::named("marvin");
  config.types.declare("winch", {"hook", "motion"});
  Mission mission(config);
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.start(TaskOf(2, "winch"), kVut),
              ElementsAre("2 scheduled", "1 aborting", "interrupt 1"));
}

TEST(InsertionMode, IsWrittenAndReadBack) {
  for (const InsertionMode mode : {kSeq, kVut, kDep, kNut}) {
    EXPECT_EQ(insertion_mode_from(to_text(mode)), mode);
  }
  EXPECT_EQ(insertion_mode_from("seq"), std::nullopt);
}

TEST(RequestKind, IsWrittenAndReadBack) {
  for (const std::string text : {"START", "ABORT", "PROCESS-MSG", "UPDATE-COND", "SUPPRESS"}) {
    const std::optional<RequestKind> kind = request_kind_from(text);
    ASSERT_TRUE(kind.has_value()) << text;
    EXPECT_EQ(to_text(*kind), text);
  }
  EXPECT_EQ(request_kind_from("STOP"), std::nullopt);
}

// --- resources of a type ---

TEST(TypeTable, ResolvesAResourceNamedByAParameter) {
  TypeTable table = TypeTable::elementary();
  table.declare("scan", {"motion", "$device", "motion"});

  EXPECT_THAT(table.resources_of("scan", Parameters{{"device", "lidar", {}}}),
              ElementsAre("lidar", "motion"));
  EXPECT_THAT(table.resources_of("takeshot", Parameters{}), ElementsAre(""));
  EXPECT_THAT(table.resources_of("never heard of", Parameters{}), IsEmpty());
}

TEST(TypeTable, WhatKeepsTheVehicleUsesMotionAsWhatMovesItDoes) {
  const TypeTable table = TypeTable::elementary();

  EXPECT_THAT(table.resources_of("goto", Parameters{}), ElementsAre("motion"));
  EXPECT_THAT(table.resources_of("rendezvous", Parameters{}), ElementsAre("motion"));
  for (const char* type : {"perceive", "monitor"})
    EXPECT_THAT(table.resources_of(type, Parameters{{"device", "ir", {}}}),
                ElementsAre("ir", "motion"))
        << type;
  EXPECT_THAT(table.resources_of("synchronise", Parameters{}), IsEmpty());
}

TEST(TypeTable, AJointTaskUsesWhatItsPartsUse) {
  EXPECT_THAT(TypeTable::elementary().resources_of("joint:track", Parameters{}), IsEmpty());
}

TEST(TypeTable, WhatIsDeclaredHereReplacesWhatTheRegistrySays) {
  TypeTable table = TypeTable::elementary();
  table.declare("goto", {});

  EXPECT_THAT(table.resources_of("goto", Parameters{}), IsEmpty());
}

TEST(TypeTable, KnowsTheElementaryAndTheJointTypes) {
  const TypeTable table = TypeTable::elementary();

  for (const char* type : {"takeoff", "land", "goto", "wait", "takeshot", "perceive", "monitor",
                           "synchronise", "rendezvous"}) {
    EXPECT_TRUE(table.is_declared(type)) << type;
  }
  EXPECT_TRUE(table.is_declared("joint:track"));
  EXPECT_FALSE(table.is_declared("spray"));
}

}  // namespace
}  // namespace skein::executive
