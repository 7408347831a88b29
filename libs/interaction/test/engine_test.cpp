// SPDX-License-Identifier: Apache-2.0
// The rules of spec 7.8, one by one.
#include "skein/interaction/engine.hpp"

#include <gmock/gmock.h>

#include "testing/played.hpp"

namespace skein::interaction {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::Played;

// --- activation ----------------------------------------------------------------------------------

TEST(Engine, ActivationTellsTheBlockItsParametersAndItsContentInOrder) {
  Played played(R"(
block: b
local: {p: best-view(), q: valid-position()}
content: [{task: t, type: goto}, {block: c, pre: [[{message: go}]], content: [{task: u, type: goto}]},
          {action: a, modality: role-allocation}])");

  EXPECT_THAT(played.lines(),
              ElementsAre("b scheduled", "b running", "compute p", "compute q", "t scheduled",
                          "run t", "c scheduled", "a scheduled", "a running", "negotiate a"));
}

// T V.4.2: a block put into BI waits for the next cycle. So blocks of one depth come before those
// below.
TEST(Engine, ABlockThatBecomesInactiveIsLookedAtInTheNextStep) {
  Played played(R"(
block: b
content:
  - {block: c, content: [{block: d, content: [{task: t, type: goto}]}]}
  - {block: e, content: [{task: u, type: goto}]})");

  EXPECT_THAT(played.lines(), ElementsAre("b scheduled", "b running", "c scheduled", "e scheduled",
                                          "c running", "d scheduled", "e running", "u scheduled",
                                          "run u", "d running", "t scheduled", "run t"));
}

TEST(Engine, AnExitThatIsTrueAtOnceArchivesTheBlockBeforeItIsActivated) {
  Played played(R"(
block: b
content:
  - {task: t, type: goto}
  - {block: c, exit: [[{componel: t, state: scheduled}]], content: [{task: u, type: goto}]})");

  EXPECT_THAT(played.lines(), ElementsAre("b scheduled", "b running", "t scheduled", "run t",
                                          "c scheduled", "c aborted"));
}

TEST(Engine, APreconditionThatCanNeverBeTrueArchivesTheBlock) {
  Played played(R"(
block: b
content:
  - {task: t, type: goto}
  - {task: v, type: goto}
  - {block: c, pre: [[{componel: t, state: ended}]], content: [{task: u, type: goto}]})");

  EXPECT_THAT(played.aborted("t").lines(), ElementsAre("t aborted", "c aborted"));
}

TEST(Engine, AnOptionalConditionThatCanNeverBeTrueCountsAsTrue) {
  Played played(R"(
block: b
content:
  - {task: t, type: goto}
  - {block: c, pre: [[{componel: t, state: ended, modality: optional}]], content: [{task: u, type: goto}]})");

  EXPECT_THAT(played.aborted("t").lines(),
              ElementsAre("t aborted", "c running", "u scheduled", "run u"));
}

// --- the end of contents -------------------------------------------------------------------------

TEST(Engine, APlanEndsWithTheLastOfItsContentHoweverThatCameOut) {
  Played played("{block: b, content: [{task: t, type: goto}, {task: u, type: goto}]}");

  EXPECT_THAT(played.aborted("t").lines(), ElementsAre("t aborted"));
  EXPECT_THAT(played.ended("u").lines(), ElementsAre("u ended", "b ended", "model ended"));
}

TEST(Engine, ALoopBeginsAnewWithoutARunningOfItsOwn) {
  Played played("{block: b, type: loop, local: {p: f()}, content: [{task: t, type: goto}]}");

  EXPECT_THAT(played.ended("t").lines(),
              ElementsAre("t ended", "compute p", "t scheduled", "run t"));
}

constexpr const char* kImmediate = R"(
block: b
TYPE
content:
  - {block: c, end: immediate, content: [{task: t, type: goto}]}
  - {block: d, pre: [[{message: go}]], content: [{task: u, type: goto}]}
  - {block: e, content: [{action: a, modality: role-allocation}]})";

std::string immediate_in(const std::string& type) {
  std::string text = kImmediate;
  return text.replace(text.find("TYPE"), 4, type);
}

TEST(Engine, TheEndOfAnImmediateBlockEndsThePlanAroundItAfterTheRestHasStopped) {
  Played played(immediate_in("type: plan"));

  EXPECT_THAT(played.ended("t").lines(), ElementsAre("t ended", "c ended", "d aborted",
                                                     "e aborting", "a aborting", "withdraw a"));
  EXPECT_THAT(played.aborted("a").lines(),
              ElementsAre("a aborted", "e aborted", "b ended", "model ended"));
}

TEST(Engine, TheEndOfAnImmediateBlockMakesTheLoopAroundItBeginAnew) {
  Played played(immediate_in("type: loop"));
  played.ended("t");

  EXPECT_THAT(played.ended("a").lines(),
              ElementsAre("a aborted", "e aborted", "c scheduled", "d scheduled", "e scheduled",
                          "c running", "t scheduled", "run t", "e running", "a scheduled",
                          "a running", "negotiate a"));
}

TEST(Engine, AnImmediateBlockThatIsAbortedEndsNothing) {
  Played played(R"(
block: b
content:
  - {block: c, end: immediate, exit: [[{message: stop}]], content: [{task: t, type: goto}]}
  - {task: u, type: goto})");
  played.message("stop");

  EXPECT_THAT(played.aborted("t").lines(), ElementsAre("t aborted", "c aborted"));
}

// --- leaving -------------------------------------------------------------------------------------

TEST(Engine, WhatIsInterruptedNeverCountsAsEnded) {
  Played played("{block: b, exit: [[{message: stop}]], content: [{task: t, type: goto}]}");

  EXPECT_THAT(played.message("stop").lines(),
              ElementsAre("b reads stop", "b aborting", "t aborting", "interrupt t"));
  EXPECT_THAT(played.ended("t").lines(), ElementsAre("t aborted", "b aborted", "model aborted"));
}

TEST(Engine, ABlockOnItsWayToItsEndCanStillBeAborted) {
  Played played(immediate_in("type: plan"));
  played.ended("t");

  EXPECT_THAT(played.at(1, Abort{}).lines(), ElementsAre("b aborting"));
  EXPECT_THAT(played.aborted("a").lines(),
              ElementsAre("a aborted", "e aborted", "b aborted", "model aborted"));
}

TEST(Engine, TheExitOfALeavingBlockIsNotLookedAt) {
  Played played("{block: b, exit: [[{message: stop}]], content: [{task: t, type: goto}]}");
  played.message("stop");

  EXPECT_THAT(played.message("stop").lines(), IsEmpty());
}

TEST(Engine, ALoopWhoseTrueExitsAllContinueInterruptsItsContentAndBeginsAnew) {
  Played played(R"(
block: b
type: loop
exit: [[{message: again, effect: continue}, {message: stop}]]
content: [{task: t, type: goto}])");

  EXPECT_THAT(played.message("again").lines(),
              ElementsAre("b reads again", "t aborting", "interrupt t"));
  EXPECT_THAT(played.aborted("t").lines(), ElementsAre("t aborted", "t scheduled", "run t"));
  played.message("again");
  EXPECT_THAT(played.message("stop").lines(), IsEmpty()) << "it is leaving already";
  EXPECT_THAT(played.aborted("t").lines(),
              ElementsAre("t aborted", "t scheduled", "run t", "b reads stop", "b aborting",
                          "t aborting", "interrupt t"))
      << "and kept what was pending for it";
}

TEST(Engine, OneTrueExitIsEnoughToEndALoop) {
  Played played(R"(
block: b
type: loop
exit: [[{message: again, effect: continue}], [{componel: t, state: running}]]
content: [{task: t, type: goto}])");
  played.running("t");

  EXPECT_THAT(played.message("again").lines(), Contains("b aborting"));
}

TEST(Engine, ALoopThatBeginsAnewForEverAtOneInstantAbortsTheModelWithAReason) {
  Played played(R"(
block: b
content:
  - {task: u, type: goto}
  - block: c
    type: loop
    pre: [[{message: go}]]
    content: [{block: d, pre: [[{message: never}]], exit: [[{time: 0, is: passed}]], content: [{task: t, type: goto}]}])");

  const auto lines = played.message("go").lines();

  EXPECT_EQ(std::count(lines.begin(), lines.end(), "d scheduled"), 1000);
  EXPECT_THAT(lines, Contains("interrupt u"));
  EXPECT_THAT(played.aborted("u").lines(), Contains("model aborted"));
}

// --- states as conditions ------------------------------------------------------------------------

TEST(Engine, WhatBeginsAnewHasNoStateWhateverItsDepth) {
  Played played(R"(
block: b
type: loop
exit: [[{componel: t, state: ended}]]
content: [{block: c, content: [{task: t, type: goto}]}])");

  EXPECT_THAT(played.ended("t").lines(),
              ElementsAre("t ended", "c ended", "c scheduled", "c running", "t scheduled", "run t"))
      << "the end of t is forgotten before an exit is looked at";
}

TEST(Engine, ConditionsSeeWhatEarlierStepsOfTheCycleDid) {
  Played played(R"(
block: b
content:
  - {block: c, exit: [[{message: stop}]], content: [{block: d, pre: [[{message: never}]], content: [{task: t, type: goto}]}]}
  - {block: e, pre: [[{componel: c, state: over}]], content: [{task: u, type: goto}]})");

  EXPECT_THAT(played.message("stop").lines(),
              ElementsAre("c reads stop", "c aborting", "d aborted", "c aborted", "e running",
                          "u scheduled", "run u"));
}

TEST(Engine, AStatusThatFitsNoStateChangesNothing) {
  Played played(
      "{block: b, type: loop, content: [{task: t, type: goto}, {block: c, pre: [[{message: "
      "go}]], content: [{task: u, type: goto}]}]}");

  EXPECT_THAT(played.ended("u").lines(), IsEmpty()) << "not activated yet";
  EXPECT_THAT(played.running("t").lines(), ElementsAre("t running"));
  EXPECT_THAT(played.running("t").lines(), IsEmpty());
  EXPECT_THAT(played.ended("t").lines(), ElementsAre("t ended"));
  EXPECT_THAT(played.aborted("t").lines(), IsEmpty());
}

// --- messages ------------------------------------------------------------------------------------

constexpr const char* kTwoListeners = R"(
block: b
content:
  - {block: c, pre: [[{message: go}], [{componel: t, state: ended}]], content: [{task: u, type: goto}]}
  - {block: d, pre: [[{message: go}]], content: [{task: v, type: goto}]}
  - {task: t, type: goto})";

TEST(Engine, AMessageIsPendingForEachBlockUntilThatBlockReadsIt) {
  Played played(kTwoListeners);

  EXPECT_THAT(played.message("go").lines(),
              ElementsAre("d reads go", "d running", "v scheduled", "run v"));
  EXPECT_THAT(played.ended("t").lines(),
              ElementsAre("t ended", "c reads go", "c running", "u scheduled", "run u"));
}

TEST(Engine, AMessageBeforeABlockIsThereIsNotForIt) {
  Played played(
      "{block: b, pre: [[{time: 5, is: passed}]], content: [{task: t, type: goto}, {block: "
      "c, pre: [[{message: go}]], content: [{task: u, type: goto}]}]}");
  played.message("go");

  EXPECT_THAT(played.at(5, Tick{}).lines(), Not(Contains("c running")));
  EXPECT_THAT(played.message("go").lines(), Contains("c running"));
}

TEST(Engine, AMessageThatTheFormulaOnlyDeniesIsNotRead) {
  Played played(
      "{block: b, pre: [[{message: wait, not: true}]], content: [{task: t, type: goto}]}");

  EXPECT_THAT(played.lines(), ElementsAre("b scheduled", "b running", "t scheduled", "run t"));
}

TEST(Engine, AllPendingMessagesThatTheFormulaNamesAreReadInItsOrder) {
  Played played(
      "{block: b, exit: [[{message: one}, {message: two}], [{componel: t, state: running}]], "
      "content: [{task: t, type: goto}]}");
  played.message("two");
  played.message("one");

  EXPECT_THAT(played.running("t").lines(), ElementsAre("t running", "b reads one", "b reads two",
                                                       "b aborting", "t aborting", "interrupt t"));
}

TEST(Engine, WhatTheCheckerFoundIsHeardWhileABlockWithThatScmIsActive) {
  Played played(R"(
block: b
content:
  - {task: t, type: goto}
  - {block: c, scms: [near], pre: [[{componel: t, state: ended}]], content: [{task: u, type: goto}]}
  - {block: d, pre: [[{message: near violated}]], content: [{task: v, type: goto}]})");
  const ScmReport report{"near", ScmReport::Finding::kViolated};

  EXPECT_THAT(played.at(1, report).lines(), IsEmpty());
  played.ended("t");
  EXPECT_THAT(played.at(2, report).lines(), Contains("d reads near violated"));
}

// --- time ----------------------------------------------------------------------------------------

TEST(Engine, InstantsBetweenInputsArePlayedEachAtItsOwn) {
  Played played(R"(
block: b
content:
  - {block: c, pre: [[{time: 5, is: passed}]], content: [{task: t, type: goto}]}
  - {block: d, pre: [[{time: 3, since: start, is: passed}]], content: [{task: u, type: goto}]})",
                10);

  EXPECT_THAT(played.lines(), Contains("c running")) << "5 s after the epoch have passed";
  EXPECT_EQ(played.engine().next_wakeup(), MissionTime::seconds(13));
  EXPECT_THAT(played.at(20, Tick{}).lines(), ElementsAre("d running", "u scheduled", "run u"));
  EXPECT_EQ(played.last_instant(), "13");
}

TEST(Engine, AnInstantOfTheInputsOwnComesBeforeTheInput) {
  Played played("{block: b, exit: [[{time: 5, is: passed}]], content: [{task: t, type: goto}]}");

  EXPECT_THAT(played.at(5, Status{"t", Status::Word::kEnded}).lines(),
              ElementsAre("b aborting", "t aborting", "interrupt t", "t aborted", "b aborted",
                          "model aborted"));
}

TEST(Engine, TimeSinceAnEventBeginsAnewWithTheActivation) {
  Played played(R"(
block: b
type: loop
exit: [[{time: 10, since: "t:running", is: passed}]]
content: [{task: t, type: goto}])");
  played.at(2, Status{"t", Status::Word::kRunning});
  played.at(8, Status{"t", Status::Word::kEnded});

  EXPECT_THAT(played.at(15, Tick{}).lines(), IsEmpty()) << "the t that ran at 2 is forgotten";
  played.at(20, Status{"t", Status::Word::kRunning});
  EXPECT_THAT(played.at(40, Tick{}).lines(), Contains("b aborting"));
  EXPECT_EQ(played.last_instant(), "30");
}

TEST(Engine, NotYetPassedCanNeverBeTrueOnceItHasPassed) {
  Played played(
      "{block: b, content: [{task: t, type: goto}, {block: c, pre: [[{time: 5, is: "
      "not-yet-passed}], [{message: go}]], content: [{task: u, type: goto}]}]}");

  EXPECT_THAT(played.at(9, Tick{}).lines(), ElementsAre("c aborted"));
  EXPECT_EQ(played.last_instant(), "5");
}

// --- start, abort, refusals ----------------------------------------------------------------------

TEST(Engine, AbortOfAModelThatWaitsIsItsEnd) {
  Played played("{block: b, pre: [[{message: go}]], content: [{task: t, type: goto}]}");

  EXPECT_THAT(played.at(3, Abort{}).lines(), ElementsAre("b aborted", "model aborted"));
  EXPECT_THAT(played.message("go").lines(), IsEmpty());
  EXPECT_TRUE(played.engine().is_over());
}

TEST(Engine, RefusesWhatMakesNoSense) {
  Played played("{block: b, content: [{task: t, type: goto}]}", 10);

  EXPECT_THAT(played.at(9, Tick{}).refusal(), HasSubstr("before 10"));
  EXPECT_THAT(played.at(11, Start{}).refusal(), HasSubstr("already"));
  EXPECT_THAT(played.ended("x").refusal(), HasSubstr("unknown componel 'x'"));
  EXPECT_THAT(played.ended("b").refusal(), HasSubstr("is a block"));
  EXPECT_EQ(played.ended("t").refusal(), "") << "and goes on";
}

}  // namespace
}  // namespace skein::interaction
