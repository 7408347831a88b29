// SPDX-License-Identifier: Apache-2.0
// The life of a task, the five requests, coherence, and the order in which things happen.
#include "skein/executive/executive.hpp"

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
using testing::passed;
using ::testing::SizeIs;
using testing::TaskOf;
using testing::Words;
using enum TaskState;
using enum InsertionMode;

Task waiting_goto(std::uint64_t id) { return TaskOf(id, "goto").pre({cm("go")}); }

// --- the life of a task (spec 2.1) ---

TEST(Executive, DispatchesATaskWithoutPreconditionsAtOnce) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(1, "goto")),
              ElementsAre("1 scheduled", "1 started", "dispatch 1"));
}

TEST(Executive, AnswersARequestBeforeItsEffects) {
  Mission mission;

  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(testing::show(mission.effects),
              ElementsAre("accepted START", "1 scheduled", "1 started", "dispatch 1"));
}

TEST(Executive, FollowsTheStatusesOfWhoCarriesTheTaskOut) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.runs(1), ElementsAre("1 running"));
  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended"));
}

TEST(Executive, LetsAStartedTaskEndWithoutRunning) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended"));
}

TEST(Executive, TakesAnAbortedThatAnswersADispatchForARejection) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.aborted(1), ElementsAre("1 aborted"));
  EXPECT_EQ(mission.reason_of(1), "rejected");
}

TEST(Executive, KeepsTheReasonThatTheFunctionalLayerGives) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));

  mission.status(1, kAborted, "no path");

  EXPECT_EQ(mission.reason_of(1), "no path");
}

TEST(Executive, NeverCountsAnInterruptedTaskAsEnded) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.runs(1);
  mission.abort(1);

  EXPECT_THAT(mission.ends(1), ElementsAre("1 aborted"));
  EXPECT_EQ(mission.reason_of(1), "abort requested");
}

// Found by random missions (--anything 48): an engine failed, and a camera that was to stop with
// the flight had stopped by itself; the interruption was answered by what had been told of it last.
TEST(Executive, TakesTheAnswerToAnInterruptionThatMetATaskWhichWasOver) {
  for (const TaskState over : {kEnded, kAborted}) {
    Mission mission;
    mission.start(TaskOf(1, "goto"));
    mission.runs(1);
    mission.abort(1);

    EXPECT_THAT(mission.status(1, over), ElementsAre("1 aborted"));
    EXPECT_THAT(mission.status(1, over), IsEmpty());
    EXPECT_THAT(mission.notices, IsEmpty());
    EXPECT_THAT(mission.status(1, over), IsEmpty());
    EXPECT_THAT(mission.notices, SizeIs(1)) << "it was answered";
  }
}

TEST(Executive, TellsTheCauseOfAnAbortAsWhoCarriesItOutDid) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));

  mission.give(FunctionalStatus{TaskId{1}, kAborted, "it waits", AbortCause::kNoAir});

  EXPECT_EQ(mission.executive.find(TaskId{1})->cause, AbortCause::kNoAir);
}

TEST(Executive, TellsThatAnAbortWasRequestedWhateverTheVehicleSaysOfIt) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.runs(1);
  mission.abort(1);

  mission.give(FunctionalStatus{TaskId{1}, kAborted, "it waits", AbortCause::kNoAir});

  EXPECT_EQ(mission.executive.find(TaskId{1})->cause, AbortCause::kRequested);
}

TEST(Executive, OnlyNoticesStatusesThatDoNotFit) {
  Mission mission;
  mission.start(waiting_goto(1));
  mission.start(TaskOf(2, "goto"));
  mission.runs(2);
  mission.start(TaskOf(3, "goto"));
  mission.ends(3);
  const std::vector<std::pair<std::uint64_t, TaskState>> misfits = {
      {1, kRunning},   {1, kEnded},   {1, kAborted}, {2, kRunning}, {2, kStarted}, {2, kAborting},
      {2, kScheduled}, {3, kRunning}, {3, kEnded},   {3, kAborted}, {9, kEnded}};

  for (const auto& [id, state] : misfits) {
    EXPECT_THAT(mission.status(id, state), IsEmpty()) << id << " " << to_text(state);
    EXPECT_THAT(mission.notices, SizeIs(1)) << id << " " << to_text(state);
  }
  EXPECT_EQ(mission.state_of(1), kScheduled);
  EXPECT_EQ(mission.state_of(2), kRunning);
  EXPECT_EQ(mission.state_of(3), kEnded);
}

TEST(Executive, OnlyNoticesRunningOfATaskThatIsAborting) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.abort(1);

  EXPECT_THAT(mission.runs(1), IsEmpty());
  EXPECT_THAT(mission.notices, ElementsAre(HasSubstr("aborting")));
  EXPECT_EQ(mission.state_of(1), kAborting);
}

// --- coherence at START (spec 2.3) ---

TEST(Executive, AbortsAtOnceATaskThatNamesOneNotInsertedBefore) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(1, "goto").pre({ce(2, kEnded)})), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.start(TaskOf(3, "goto").exit({ce(4, kEnded)})), ElementsAre("3 aborted"));
}

TEST(Executive, AbortsAtOnceATaskThatNamesItself) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(1, "goto").pre({ce(1, kScheduled)})), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.reason_of(1), HasSubstr("itself"));
}

TEST(Executive, AbortsAtOnceATaskWhosePreconditionsAreFalseForEver) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.aborted(1);

  EXPECT_THAT(mission.start(TaskOf(2, "goto").pre({ce(1, kEnded)})), ElementsAre("2 aborted"));
}

TEST(Executive, AbortsAtOnceATaskWhoseExitConditionsAreSatisfiedAlready) {
  Mission mission;
  mission.message("stop");

  EXPECT_THAT(mission.start(TaskOf(1, "goto").exit({cm("stop")})), ElementsAre("1 aborted"));
}

TEST(Executive, RemembersAnIncoherentTaskAsAborted) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({ce(7, kEnded)}));

  EXPECT_THAT(mission.start(TaskOf(2, "wait").pre({ce(1, kAborted)})),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
  EXPECT_THAT(mission.start(TaskOf(1, "goto")), ElementsAre("refused START"));
}

TEST(Executive, RefusesAnIdThatIsKnownEvenAfterItsSuppression) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  EXPECT_THAT(mission.start(TaskOf(1, "land")), ElementsAre("refused START"));
  mission.ends(1);
  mission.suppress(1);

  EXPECT_THAT(mission.start(TaskOf(1, "goto")), ElementsAre("refused START"));
  EXPECT_THAT(mission.why(), HasSubstr("known"));
}

TEST(Executive, RefusesTheIdsOfTheBackgroundRoutine) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(kFirstBackgroundId.value(), "goto")),
              ElementsAre("refused START"));
}

TEST(Executive, RefusesASynchronisationOnAnotherTypeAndTheTypeWithoutOne) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(1, "synchronise")), ElementsAre("refused START"));
  EXPECT_THAT(mission.start(TaskOf(1, "goto").among({"heliv"}, {"marvin"})),
              ElementsAre("refused START"));
}

TEST(Executive, AcceptsATypeThatIsNotDeclaredAndSaysSo) {
  Mission mission;

  EXPECT_THAT(mission.start(TaskOf(1, "spray")),
              ElementsAre("1 scheduled", "1 started", "dispatch 1"));
  EXPECT_THAT(mission.notices, ElementsAre(HasSubstr("spray")));
}

// --- ABORT, SUPPRESS, UPDATE-COND ---

TEST(Executive, CancelsAScheduledTaskAtOnce) {
  Mission mission;
  mission.start(waiting_goto(1));

  EXPECT_THAT(mission.abort(1), ElementsAre("1 aborted"));
}

TEST(Executive, InterruptsAStartedOrRunningTaskAndWaitsForTheConfirmation) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.start(TaskOf(2, "takeshot"));
  mission.runs(2);

  EXPECT_THAT(mission.abort(1), ElementsAre("1 aborting", "interrupt 1"));
  EXPECT_THAT(mission.abort(2), ElementsAre("2 aborting", "interrupt 2"));
  EXPECT_THAT(mission.aborted(2), ElementsAre("2 aborted"));
}

TEST(Executive, AcceptsWithoutEffectAnAbortOfATaskAbortingOrTerminal) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.abort(1);

  EXPECT_THAT(mission.abort(1), IsEmpty());
  mission.aborted(1);
  EXPECT_THAT(mission.abort(1), IsEmpty());
}

TEST(Executive, RefusesAnyRequestOnAnUnknownId) {
  Mission mission;

  EXPECT_THAT(mission.abort(5), ElementsAre("refused ABORT"));
  EXPECT_THAT(mission.suppress(5), ElementsAre("refused SUPPRESS"));
  EXPECT_THAT(mission.update(5, Formula{}, {}), ElementsAre("refused UPDATE-COND"));
}

TEST(Executive, SuppressesOnlyWhatIsTerminal) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  EXPECT_THAT(mission.suppress(1), ElementsAre("refused SUPPRESS"));
  mission.ends(1);

  EXPECT_THAT(mission.suppress(1), IsEmpty());
  EXPECT_FALSE(mission.executive.find(TaskId{1}).has_value());
  EXPECT_THAT(mission.suppress(1), ElementsAre("refused SUPPRESS"));
}

TEST(Executive, KeepsTheFactsOfASuppressedTask) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.ends(1);
  mission.suppress(1);

  EXPECT_THAT(mission.start(TaskOf(2, "land").pre({ce(1, kEnded)})),
              ElementsAre("2 scheduled", "2 started", "dispatch 2"));
  EXPECT_THAT(mission.start(TaskOf(3, "land").pre({ce(1, kAborted)})), ElementsAre("3 aborted"));
}

TEST(Executive, UpdatesBothConditionsOfAScheduledTask) {
  Mission mission;
  mission.start(waiting_goto(1));

  EXPECT_THAT(mission.update(1, Formula{{cm("now")}}, Formula{{cm("stop")}}), IsEmpty());
  EXPECT_THAT(mission.message("go"), IsEmpty());
  EXPECT_THAT(mission.message("now"), ElementsAre("1 started", "dispatch 1"));
  EXPECT_THAT(mission.message("stop"), ElementsAre("1 aborting", "interrupt 1"));
}

TEST(Executive, DispatchesATaskWhoseUpdatedPreconditionsHold) {
  Mission mission;
  mission.start(waiting_goto(1));

  EXPECT_THAT(mission.update(1, Formula{}, {}), ElementsAre("1 started", "dispatch 1"));
}

TEST(Executive, LeavesBothConditionsAsTheyWereWhenAnUpdateIsRefused) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("go")}).exit({cm("stop")}));
  mission.message("over");

  EXPECT_THAT(mission.update(1, Formula{}, Formula{{cm("over")}}),
              ElementsAre("refused UPDATE-COND"));
  EXPECT_THAT(mission.update(1, Formula{{ce(9, kEnded)}}, Formula{}),
              ElementsAre("refused UPDATE-COND"));

  EXPECT_EQ(mission.executive.preconditions(TaskId{1}), (Formula{{cm("go")}}));
  EXPECT_EQ(mission.executive.exit_conditions(TaskId{1}), (Formula{{cm("stop")}}));
  EXPECT_THAT(mission.message("go"), ElementsAre("1 started", "dispatch 1"));
}

TEST(Executive, RefusesAnUpdateThatCouldNeverLetTheTaskGo) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));
  mission.aborted(1);
  mission.start(waiting_goto(2));

  EXPECT_THAT(mission.update(2, Formula{{ce(1, kEnded)}}, {}), ElementsAre("refused UPDATE-COND"));
  EXPECT_THAT(mission.update(2, Formula{{ce(2, kStarted)}}, {}),
              ElementsAre("refused UPDATE-COND"));
}

TEST(Executive, UpdatesPreconditionsOnlyWhileScheduledAndExitUntilTerminal) {
  Mission mission;
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.update(1, Formula{}, {}), ElementsAre("refused UPDATE-COND"));
  EXPECT_THAT(mission.update(1, {}, Formula{{cm("stop")}}), IsEmpty());
  mission.ends(1);
  EXPECT_THAT(mission.update(1, {}, Formula{}), ElementsAre("refused UPDATE-COND"));
}

// --- what comes first (spec 2.4) ---

TEST(Executive, DispatchesTheLowestIdFirst) {
  Mission mission;
  for (const std::uint64_t id : {7U, 3U, 5U}) mission.start(waiting_goto(id));

  EXPECT_THAT(mission.message("go"), ElementsAre("3 started", "dispatch 3", "5 started",
                                                 "dispatch 5", "7 started", "dispatch 7"));
}

TEST(Executive, LetsTheExitConditionsWinWhenBothBecomeTrue) {
  Mission mission;
  mission.start(TaskOf(1, "goto").pre({cm("now")}).exit({cm("now")}));

  EXPECT_THAT(mission.message("now"), ElementsAre("1 aborted"));
}

TEST(Executive, InterruptsBeforeItDispatchesWhateverTheIds) {
  Mission mission;
  mission.start(TaskOf(2, "takeshot").exit({cm("now")}));
  mission.start(TaskOf(1, "goto").pre({cm("now")}));

  EXPECT_THAT(mission.message("now"),
              ElementsAre("2 aborting", "interrupt 2", "1 started", "dispatch 1"));
}

TEST(Executive, CascadesAnAbortThroughMandatoryDependences) {
  Mission mission;
  mission.start(waiting_goto(1));
  mission.start(TaskOf(2, "goto"), kDep);
  mission.start(TaskOf(3, "goto"), kDep);

  EXPECT_THAT(mission.abort(1), ElementsAre("1 aborted", "2 aborted", "3 aborted"));
}

TEST(Executive, RunsTheExampleOfTheThesis) {
  Mission mission;
  mission.start(TaskOf(1, "takeoff"), kVut);
  mission.start(TaskOf(2, "goto"), kDep);
  mission.start(
      TaskOf(3, "takeshot").pre({ce(2, kRunning)}).exit({testing::optional(ce(2, kEnded))}));
  mission.start(TaskOf(4, "land"), kNut);
  mission.runs(1);

  EXPECT_THAT(mission.ends(1), ElementsAre("1 ended", "2 started", "dispatch 2"));
  EXPECT_THAT(mission.runs(2), ElementsAre("2 running", "3 started", "dispatch 3"));
  EXPECT_THAT(mission.runs(3), ElementsAre("3 running"));
  EXPECT_THAT(mission.abort(2), ElementsAre("2 aborting", "interrupt 2"));
  EXPECT_THAT(mission.aborted(2), ElementsAre("2 aborted", "3 aborting", "interrupt 3"));
  EXPECT_THAT(mission.aborted(3), ElementsAre("3 aborted", "4 started", "dispatch 4"));
}

// --- the functional layer that never answers (spec 2.6) ---

Config impatient() {
  Config config = testing::named("marvin");
  config.functional_timeout = Duration::seconds(3);
  return config;
}

TEST(Executive, AbortsATaskWhoseDispatchIsNotAnsweredInTime) {
  Mission mission(impatient());
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.at(2.9).tick(), IsEmpty());
  EXPECT_THAT(mission.at(3).tick(), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.reason_of(1), HasSubstr("time-out"));
}

// Found over DDS: a flight that waited for its air was flown after it had been given up.
TEST(Executive, InterruptsWhatIsNotAnsweredInTimeIfItIsTo) {
  Config config = impatient();
  config.interrupts_unanswered = true;
  Mission mission(config);
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.at(3).tick(), ElementsAre("1 aborted", "interrupt 1"));
  EXPECT_THAT(mission.aborted(1), IsEmpty());
  EXPECT_THAT(mission.notices, IsEmpty()) << "that was the answer";
}

TEST(Executive, IsPatientWithATaskThatIsSaidToCome) {
  Mission mission(impatient());
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.at(2).status(1, TaskState::kStarted), IsEmpty());
  EXPECT_THAT(mission.notices, IsEmpty());
  EXPECT_THAT(mission.at(4.9).tick(), IsEmpty());
  EXPECT_THAT(mission.at(5).tick(), ElementsAre("1 aborted"));
}

TEST(Executive, AbortsATaskWhoseInterruptionIsNotAnsweredInTime) {
  Mission mission(impatient());
  mission.start(TaskOf(1, "goto"));
  mission.runs(1);

  EXPECT_THAT(mission.at(60).tick(), IsEmpty()) << "a task may run for as long as it likes";
  mission.abort(1);
  EXPECT_THAT(mission.at(63).tick(), ElementsAre("1 aborted"));
}

TEST(Executive, PassesTimeBeforeTheInputOfTheSameInstant) {
  Mission mission(impatient());
  mission.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission.at(3).runs(1), ElementsAre("1 aborted"));
  EXPECT_THAT(mission.notices, SizeIs(1));
}

TEST(Executive, NeverGoesBackInTime) {
  Mission mission;
  mission.at(10).tick();

  EXPECT_THAT(mission.at(2).start(TaskOf(1, "goto").pre({passed(9)})),
              ElementsAre("1 scheduled", "1 started", "dispatch 1"));
}

// --- what may be asked of it ---

TEST(Executive, ListsThePlanInTheOrderOfIds) {
  Mission mission;
  for (const std::uint64_t id : {4U, 2U, 9U}) mission.start(waiting_goto(id));
  mission.abort(4);

  EXPECT_THAT(mission.executive.tasks(),
              ElementsAre(TaskStatus{TaskId{2}, "goto", kScheduled, ""},
                          TaskStatus{TaskId{4}, "goto", kAborted, "abort requested"},
                          TaskStatus{TaskId{9}, "goto", kScheduled, ""}));
}

TEST(Executive, KeepsTheParametersForWhoCarriesTheTaskOut) {
  Mission mission;
  mission.start(TaskOf(1, "takeshot").device("camera"));

  const std::optional<TaskView> view = mission.executive.find(TaskId{1});

  ASSERT_TRUE(view.has_value());
  ASSERT_NE(view->parameters.find("device"), nullptr);
  EXPECT_EQ(view->parameters.find("device")->text, "camera");
  EXPECT_EQ(view->parameters.find("zone"), nullptr);
  EXPECT_EQ(view->synchronisation, nullptr);
}

}  // namespace
}  // namespace skein::executive
