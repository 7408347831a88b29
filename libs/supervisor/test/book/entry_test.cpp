// SPDX-License-Identifier: Apache-2.0
// The life of an elementary task between plan and executive.
#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "book/entry.hpp"

namespace skein::supervisor {
namespace {

constexpr Step kSteps[] = {Step::kGive, Step::kOrder, Step::kWithdraw, Step::kStop,
                           Step::kEnd,  Step::kAbort, Step::kExcuse};

Stage after_steps(const std::vector<Step>& steps) {
  Entry entry;
  for (const Step step : steps) entry.advance(step);
  return entry.stage();
}

/// What the stages stand for, each property kept by itself: the oracle.
struct Flags {
  bool given = false, withdrawn = false, ordered = false, told_to_stop = false, over = false,
       well = false;

  void take(Step step) {
    if (step == Step::kGive) given = true;
    if (step == Step::kOrder) ordered = told_to_stop = true;
    if (step == Step::kWithdraw) withdrawn = true;
    if (step == Step::kWithdraw) told_to_stop = false;
    if (step == Step::kStop) told_to_stop = true;
    if (step == Step::kEnd || step == Step::kAbort) over = given = true;
    if (step == Step::kEnd || step == Step::kExcuse) well = true;
  }
};

/// A life of at most eight steps that the table allows.
std::vector<Step> some_life() {
  std::vector<Step> steps;
  Stage stage = Stage::kPlanned;
  for (int left = *rc::gen::inRange(0, 9); left > 0; --left) {
    std::vector<Step> open;
    std::copy_if(std::begin(kSteps), std::end(kSteps), std::back_inserter(open),
                 [&](Step step) { return after(stage, step).has_value(); });
    if (open.empty()) break;
    steps.push_back(*rc::gen::elementOf(open));
    stage = *after(stage, steps.back());
  }
  return steps;
}

TEST(EntryStages, LeadFromThePlanThroughTheExecutiveToTheEnd) {
  EXPECT_EQ(after_steps({}), Stage::kPlanned);
  EXPECT_EQ(after_steps({Step::kGive}), Stage::kGiven);
  EXPECT_EQ(after_steps({Step::kGive, Step::kEnd}), Stage::kDone);
  EXPECT_EQ(after_steps({Step::kGive, Step::kAbort}), Stage::kLost);
}

TEST(EntryStages, WhatWasOnlyPlannedIsDroppedWithoutAWord) {
  Entry entry;
  entry.advance(Step::kWithdraw);

  EXPECT_EQ(entry.stage(), Stage::kDropped);
  EXPECT_FALSE(entry.given());
}

TEST(EntryStages, WhatTheExecutiveHasIsToBeToldToStopWhenItIsWithdrawn) {
  EXPECT_EQ(after_steps({Step::kGive, Step::kWithdraw}), Stage::kWithdrawn);
  EXPECT_EQ(after_steps({Step::kGive, Step::kWithdraw, Step::kStop}), Stage::kStopping);
}

TEST(EntryStages, AWaitThatWasEndedByOrdersIsDoneThoughItIsAborted) {
  EXPECT_EQ(after_steps({Step::kGive, Step::kOrder, Step::kAbort, Step::kExcuse}), Stage::kDone);
}

TEST(EntryStages, WhatOthersGiveThoughItWasDroppedIsWithdrawn) {
  EXPECT_EQ(after_steps({Step::kWithdraw, Step::kGive}), Stage::kWithdrawn);
}

TEST(EntryStages, NothingHappensTwiceToWhatIsOver) {
  for (const Stage stage : {Stage::kPastDone, Stage::kPastLost}) {
    for (const Step step : kSteps) {
      EXPECT_FALSE(after(stage, step)) << to_text(stage) << ", " << to_text(step);
    }
  }
  EXPECT_FALSE(after(Stage::kDone, Step::kEnd));
  EXPECT_FALSE(after(Stage::kDone, Step::kAbort));
  EXPECT_FALSE(after(Stage::kLost, Step::kGive));
}

TEST(EntryStages, AStepThatTheTableDoesNotHaveIsAFaultOfTheProgram) {
  Entry entry;
  EXPECT_DEATH(entry.advance(Step::kEnd), "");
}

RC_GTEST_PROP(EntryStages, SayWhatFlagsForEachPropertyWouldSay, ()) {
  Entry entry;
  Flags flags;
  for (const Step step : some_life()) {
    entry.advance(step);
    flags.take(step);
  }
  RC_ASSERT(entry.given() == flags.given);
  RC_ASSERT(entry.live() == !flags.withdrawn);
  RC_ASSERT(entry.over() == flags.over);
  RC_ASSERT(entry.done() == flags.well);
  RC_ASSERT(entry.in_hand() == (flags.given && !flags.withdrawn && !flags.over));
  if (!flags.over) RC_ASSERT(entry.ordered() == (flags.ordered && !flags.withdrawn));
  if (!flags.over) RC_ASSERT(entry.stopping() == flags.told_to_stop);
}

RC_GTEST_PROP(EntryStages, NeverComeBackToThePlanNorFromTheEnd, ()) {
  Entry entry;
  bool given = false, withdrawn = false, over = false;
  for (const Step step : some_life()) {
    entry.advance(step);
    RC_ASSERT(entry.given() || !given);
    RC_ASSERT(!entry.live() || !withdrawn);
    RC_ASSERT(entry.over() || !over);
    given = entry.given();
    withdrawn = !entry.live();
    over = entry.over();
  }
}

}  // namespace
}  // namespace skein::supervisor
