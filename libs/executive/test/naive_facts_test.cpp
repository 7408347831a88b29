// SPDX-License-Identifier: Apache-2.0
// What the oracle holds for true, on formulas that are read by hand (spec 2.2).
#include "testing/naive_facts.hpp"

#include <gtest/gtest.h>

namespace skein::executive {
namespace {

using testing::NaiveFacts;

constexpr TaskId kOne{1}, kTwo{2};

Formula only(Condition condition, bool negated = false, Modality modality = Modality::kMandatory) {
  return {{Literal{std::move(condition), negated, modality}}};
}

NaiveFacts task_one_is(TaskState state) {
  NaiveFacts facts;
  facts.task_is(kOne, state);
  return facts;
}

TEST(NaiveFacts, WhatTheTableOfStatesStillAllowsDoesNotHoldAndMayCome) {
  const Formula ended = only(TaskInState{kOne, TaskState::kEnded});
  for (const TaskState state :
       {TaskState::kScheduled, TaskState::kStarted, TaskState::kRunning, TaskState::kAborting}) {
    EXPECT_FALSE(task_one_is(state).holds(ended)) << to_text(state);
    EXPECT_FALSE(task_one_is(state).never(ended)) << to_text(state);
  }
  EXPECT_TRUE(task_one_is(TaskState::kEnded).holds(ended));
  EXPECT_TRUE(task_one_is(TaskState::kAborted).never(ended));
}

TEST(NaiveFacts, WhatCannotComeHoldsIfItIsOptional) {
  const NaiveFacts facts = task_one_is(TaskState::kAborted);
  const Formula ended = only(TaskInState{kOne, TaskState::kEnded}, false, Modality::kOptional);

  EXPECT_TRUE(facts.holds(ended));
  EXPECT_FALSE(facts.never(ended));
}

TEST(NaiveFacts, ANegationHoldsUntilItsConditionDoesAndIsHopelessIfThatIsForEver) {
  NaiveFacts facts = task_one_is(TaskState::kRunning);
  EXPECT_FALSE(facts.holds(only(TaskInState{kOne, TaskState::kRunning}, true)));
  EXPECT_FALSE(facts.never(only(TaskInState{kOne, TaskState::kRunning}, true)));
  EXPECT_TRUE(facts.holds(only(MessageReceived{"go"}, true)));
  facts.message("go");
  EXPECT_TRUE(facts.never(only(MessageReceived{"go"}, true)));
  EXPECT_TRUE(facts.holds(only(MessageReceived{"go"})));
}

TEST(NaiveFacts, AnInstantHasPassedAtTheInstantItself) {
  const Formula passed = only(TimeIs{MissionTime::seconds(5), true});
  const Formula before = only(TimeIs{MissionTime::seconds(5), false});
  NaiveFacts facts;
  facts.time_is(MissionTime::nanoseconds(4'999'999'999));
  EXPECT_FALSE(facts.holds(passed));
  EXPECT_TRUE(facts.holds(before));

  facts.time_is(MissionTime::seconds(5));
  EXPECT_TRUE(facts.holds(passed));
  EXPECT_TRUE(facts.never(before));
}

TEST(NaiveFacts, ExitsNeedACondition) {
  NaiveFacts facts;
  facts.message("stop");

  EXPECT_TRUE(facts.holds(Formula()));
  EXPECT_FALSE(facts.exits(Formula()));
  EXPECT_TRUE(facts.exits(only(MessageReceived{"stop"})));
}

TEST(NaiveFacts, AFormulaNamesOtherTasksThatAreKnown) {
  const NaiveFacts facts = task_one_is(TaskState::kScheduled);
  const Formula of_one = only(TaskInState{kOne, TaskState::kEnded});

  EXPECT_TRUE(facts.names_only_known(kTwo, of_one));
  EXPECT_FALSE(facts.names_only_known(kOne, of_one));
  EXPECT_FALSE(facts.names_only_known(kOne, only(TaskInState{kTwo, TaskState::kEnded})));
}

TEST(NaiveFacts, ARelinquishedTaskStaysAbortedToWhoNamesItThoughItComesBack) {
  NaiveFacts facts;
  facts.relinquish(kOne);
  const Formula ended = facts.settled(only(TaskInState{kOne, TaskState::kEnded}));
  const Formula aborted = facts.settled(only(TaskInState{kOne, TaskState::kAborted}));
  facts.task_is(kOne, TaskState::kEnded);

  EXPECT_TRUE(facts.never(ended));
  EXPECT_TRUE(facts.holds(aborted));
  EXPECT_TRUE(facts.holds(facts.settled(only(TaskInState{kOne, TaskState::kEnded}))));
}

}  // namespace
}  // namespace skein::executive
