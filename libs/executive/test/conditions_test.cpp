// SPDX-License-Identifier: Apache-2.0
// What makes a literal, a clause and a formula true, false for now, or false for ever; time
// conditions among events. Source: spec 2.2, 2.4.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/mission.hpp"
#include "truth.hpp"

namespace skein::executive {
namespace {

using testing::ce;
using testing::cm;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::Mission;
using testing::no;
using testing::not_yet;
using testing::optional;
using testing::passed;
using testing::TaskOf;
using testing::Words;
using enum TaskState;

// --- conditions on tasks ---

TEST(Truth, OfATaskConditionFollowsWhatIsStillReachable) {
  using enum Standing;
  // Rows: the state the task is in; columns: the state that is asked for.
  const Standing table[6][6] = {
      {kHolds, kNotNow, kNotNow, kNotNow, kNotNow, kNotNow},              // scheduled
      {kNeverAgain, kHolds, kNotNow, kNotNow, kNotNow, kNotNow},          // started
      {kNeverAgain, kNeverAgain, kHolds, kNotNow, kNotNow, kNotNow},      // running
      {kNeverAgain, kNeverAgain, kNeverAgain, kHolds, kNotNow, kNotNow},  // aborting
      {kNeverAgain, kNeverAgain, kNeverAgain, kNeverAgain, kHoldsForEver, kNeverAgain},
      {kNeverAgain, kNeverAgain, kNeverAgain, kNeverAgain, kNeverAgain, kHoldsForEver}};

  for (std::uint8_t from = 0; from < 6; ++from) {
    for (std::uint8_t to = 0; to < 6; ++to) {
      EXPECT_EQ(standing_of_task(static_cast<TaskState>(from), static_cast<TaskState>(to)),
                table[from][to])
          << to_text(static_cast<TaskState>(from)) << " to " << to_text(static_cast<TaskState>(to));
    }
  }
}

TEST(Truth, OfALiteralThatCanNoLongerBeSatisfiedIsThatOfItsModality) {
  using enum Modality;
  EXPECT_EQ(truth_of(Standing::kNeverAgain, false, kMandatory), Truth::kNever);
  EXPECT_EQ(truth_of(Standing::kNeverAgain, false, kOptional), Truth::kTrue);
  EXPECT_EQ(truth_of(Standing::kHoldsForEver, true, kMandatory), Truth::kNever);
  EXPECT_EQ(truth_of(Standing::kHoldsForEver, true, kOptional), Truth::kTrue);
}

TEST(Truth, OfALiteralNotSettledIgnoresTheModality) {
  for (const Modality modality : {Modality::kMandatory, Modality::kOptional}) {
    EXPECT_EQ(truth_of(Standing::kHolds, false, modality), Truth::kTrue);
    EXPECT_EQ(truth_of(Standing::kHolds, true, modality), Truth::kFalse);
    EXPECT_EQ(truth_of(Standing::kNotNow, false, modality), Truth::kFalse);
    EXPECT_EQ(truth_of(Standing::kNotNow, true, modality), Truth::kTrue);
    EXPECT_EQ(truth_of(Standing::kNeverAgain, true, modality), Truth::kTrue);
    EXPECT_EQ(truth_of(Standing::kHoldsForEver, false, modality), Truth::kTrue);
  }
}

TEST(TaskState, IsWrittenAndReadBack) {
  for (const TaskState state : {kScheduled, kStarted, kRunning, kAborting, kEnded, kAborted}) {
    EXPECT_EQ(task_state_from(to_text(state)), state);
  }
  EXPECT_EQ(task_state_from("over"), std::nullopt);
}

// --- modalities, through a whole task ---

TEST(Conditions, AMandatoryLiteralThatIsOverAbortsTheTask) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot").pre({ce(1, kRunning)}));

  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", "2 aborted"));
}

TEST(Conditions, AnOptionalLiteralThatIsOverCountsAsTrue) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot").pre({optional(ce(1, kRunning))}));

  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", "2 started", "dispatch 2"));
}

TEST(Conditions, AMandatoryNegationIsOverOnceItsConditionIsSettled) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot").pre({no(ce(1, kEnded))}).pre({cm("go")}));

  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", "2 aborted"));
}

TEST(Conditions, AnOptionalNegationCountsAsTrueOnceItsConditionIsSettled) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot").pre({optional(no(ce(1, kEnded)))}).pre({cm("go")}));
  mission.ends(1);

  EXPECT_THAT(mission.message("go"), ElementsAre("2 started", "dispatch 2"));
}

TEST(Conditions, ANegationIsOnlyFalseForNowWhileItsConditionMayCeaseToHold) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.runs(1);

  EXPECT_THAT(mission.start(TaskOf(2, "takeshot").pre({no(ce(1, kRunning))})),
              ElementsAre("2 scheduled"));
  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", "2 started", "dispatch 2"));
}

TEST(Conditions, ANegatedMessageIsOverOnceTheMessageIsReceived) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({no(cm("danger"))}).pre({cm("go")}));
  mission.start(TaskOf(2, "goto").pre({optional(no(cm("danger")))}).pre({cm("go")}));

  EXPECT_THAT(mission.message("danger"), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.message("go"), ElementsAre("2 started", "dispatch 2"));
}

TEST(Conditions, AnOptionalExitConditionThatIsOverInterruptsTheTask) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot").exit({optional(ce(1, kEnded))}));

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", "2 aborting", "interrupt 2"));
}

TEST(Conditions, AMandatoryExitConditionThatIsOverNeverInterrupts) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot").exit({ce(1, kEnded)}));

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted"));
}

// --- clauses and formulas ---

TEST(Conditions, AClauseHoldsWithOneOfItsLiterals) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("left"), cm("right")}));

  EXPECT_THAT(mission.message("right"), ElementsAre("1 started", "dispatch 1"));
}

TEST(Conditions, AFormulaHoldsWithAllOfItsClauses) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("first")}).pre({cm("second")}));

  EXPECT_THAT(mission.message("second"), IsEmpty());
  EXPECT_THAT(mission.message("first"), ElementsAre("1 started", "dispatch 1"));
}

TEST(Conditions, AClauseIsOverOnlyWhenAllItsLiteralsAre) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "goto"));
  mission.start(TaskOf(3, "takeshot").pre({ce(1, kEnded), ce(2, kEnded)}));

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.aborted(2), ElementsAre("2 aborted", "3 aborted"));
}

TEST(Conditions, OneClauseThatIsOverEndsTheWholeFormula) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(3, "takeshot").pre({cm("go")}).pre({ce(1, kEnded)}));

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted", "3 aborted"));
}

TEST(Conditions, AClauseWithoutLiteralsIsFalseForEver) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(1, "goto").pre({})), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.start(TaskOf(2, "goto").exit({})),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
}

TEST(Conditions, AnEmptyExitFormulaNeverInterrupts) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.runs(1);

  EXPECT_THAT(mission.at(1e6).tick(), IsEmpty());
}

TEST(Conditions, OneLiteralMayAppearTwice) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go"), cm("go")}).pre({cm("go"), optional(cm("go"))}));

  EXPECT_THAT(mission.message("go"), ElementsAre("1 started", "dispatch 1"));
}

TEST(Conditions, AMessageReceivedBeforeTheTaskIsInsertedIsRemembered) {
  Mission mission;
  mission.message("go");

  EXPECT_THAT(mission.start(TaskOf(1, "goto").pre({cm("go")})),
              ElementsAre("1 scheduled", "1 started", "dispatch 1"));
}

TEST(Conditions, ATaskMayFollowAnIntermediateStateOfAnother) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go")}));
  mission.start(TaskOf(2, "takeshot").pre({ce(1, kStarted)}));
  mission.start(TaskOf(3, "wait").pre({ce(1, kAborting)}));

  EXPECT_THAT(mission.message("go"),
              ElementsAre("1 started", "dispatch 1", "2 started", "dispatch 2"));
  EXPECT_THAT(mission.abort(1),
              ElementsAre("1 aborting", "interrupt 1", "3 started", "dispatch 3"));
}

TEST(Conditions, ReplacedOnesNoLongerAct) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({passed(5)}).exit({cm("old")}));
  mission.update(1, Formula{{passed(50)}}, Formula{{cm("new")}});

  EXPECT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(50));
  EXPECT_THAT(mission.message("old"), IsEmpty());
  EXPECT_THAT(mission.at(49).tick(), IsEmpty());
  EXPECT_THAT(mission.at(50).tick(), ElementsAre("1 started", "dispatch 1"));
}

// --- time ---

TEST(Conditions, AnInstantHasPassedOnceItIsReached) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({passed(10)}));

  EXPECT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(10));
  EXPECT_THAT(mission.at(9.999).tick(), IsEmpty());
  EXPECT_THAT(mission.at(10).tick(), ElementsAre("1 started", "dispatch 1"));
  EXPECT_EQ(mission.executive.next_wakeup(), std::nullopt);
}

TEST(Conditions, NotYetPassedIsOverAtItsInstant) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go")}).pre({not_yet(10)}));
  mission.start(TaskOf(2, "goto").pre({cm("go")}).pre({optional(not_yet(10))}));

  EXPECT_THAT(mission.at(10).message("go"), ElementsAre("1 aborted", "2 started", "dispatch 2"));
}

TEST(Conditions, ANegatedInstantIsOverOnceItHasPassed) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go")}).pre({no(passed(10))}));
  mission.start(TaskOf(2, "goto").pre({no(not_yet(10))}));

  EXPECT_THAT(mission.at(10).tick(), ElementsAre("1 aborted", "2 started", "dispatch 2"));
}

TEST(Conditions, InstantsPassInOrderEachAsAnEventOfItsOwn) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({passed(20)}));
  mission.start(TaskOf(2, "takeshot").pre({passed(10)}).exit({ce(1, kStarted)}));

  EXPECT_THAT(mission.at(30).tick(), ElementsAre("2 started", "dispatch 2", "1 started",
                                                 "dispatch 1", "2 aborting", "interrupt 2"));
}

TEST(Conditions, AnInstantPassesBeforeTheEventThatComesWithIt) {
  Mission mission;
  mission.start(TaskOf(1, "goto").exit({passed(10)}));

  EXPECT_THAT(mission.at(10).ends(1), ElementsAre("1 aborting", "interrupt 1", "1 aborted"));
}

TEST(Conditions, AConditionOnAnInstantOfThePastIsSettledAtInsertion) {
  Mission mission;
  mission.at(20);

  EXPECT_THAT(mission.start(TaskOf(1, "goto").pre({passed(20)})),
              ElementsAre("1 scheduled", "1 started", "dispatch 1"));
  EXPECT_THAT(mission.start(TaskOf(2, "goto").pre({not_yet(20)})), ElementsAre("2 aborted"));
  EXPECT_THAT(mission.start(TaskOf(3, "goto").exit({passed(19)})), ElementsAre("3 aborted"));
}

TEST(Conditions, ATaskThatIsOverAsksForNoWakeup) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go")}).exit({passed(10)}));
  mission.start(TaskOf(2, "takeshot").exit({passed(30)}));
  mission.abort(1);

  EXPECT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(30));
  mission.ends(2);
  EXPECT_EQ(mission.executive.next_wakeup(), std::nullopt);
}

TEST(Conditions, ManyUpdatesWithInstantsFarAheadLeaveOnlyTheLast) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go")}));

  for (int i = 0; i < 1000; ++i) mission.update(1, Formula{{passed(1000.0 + i)}}, {});

  EXPECT_EQ(mission.executive.next_wakeup(), MissionTime::seconds(1999));
  EXPECT_THAT(mission.at(1998).tick(), IsEmpty());
  EXPECT_THAT(mission.at(1999).tick(), ElementsAre("1 started", "dispatch 1"));
}

}  // namespace
}  // namespace skein::executive
