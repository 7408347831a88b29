// SPDX-License-Identifier: Apache-2.0
// What an executive tells, without an executive.
#include "outbox.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/show.hpp"

namespace skein::executive {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::show;

TaskRecord task(std::uint64_t id, TaskState state, bool joint = false) {
  TaskRecord record;
  record.id = TaskId{id};
  record.state = state;
  record.joint = joint;
  return record;
}

TaskRecord joint(std::uint64_t id, TaskState state) { return task(id, state, true); }

TEST(Outbox, TellsEverythingInItsOrderAndOnce) {
  Outbox outbox;
  outbox.reply(RequestKind::kStart, TaskId{1}, std::nullopt);
  outbox.event(task(1, TaskState::kStarted));
  outbox.add(Dispatch{TaskId{1}, false});

  EXPECT_THAT(show(outbox.take()), ElementsAre("accepted START", "1 started", "dispatch 1"));
  EXPECT_THAT(outbox.take(), IsEmpty());
}

TEST(Outbox, AReplySaysWhyItRefuses) {
  Outbox outbox;
  outbox.reply(RequestKind::kAbort, TaskId{1}, "not in the plan");

  EXPECT_EQ(std::get<Reply>(outbox.take().front()),
            (Reply{RequestKind::kAbort, TaskId{1}, false, "not in the plan"}));
}

TEST(Outbox, AnEventHasTheReasonAndTheCauseOfItsTask) {
  Outbox outbox;
  TaskRecord aborted = task(1, TaskState::kAborted);
  aborted.type = "goto";
  aborted.reason = "rejected";
  aborted.cause = AbortCause::kRequested;
  outbox.event(aborted);

  EXPECT_EQ(
      std::get<TaskEvent>(outbox.take().front()),
      (TaskEvent{TaskId{1}, "goto", TaskState::kAborted, "rejected", AbortCause::kRequested}));
}

TEST(Outbox, EventsOfOthersGoToTheSupervisorFromTheStartOfAJointTaskToItsEnd) {
  Outbox outbox;
  outbox.event(joint(1, TaskState::kScheduled));
  outbox.event(task(2, TaskState::kScheduled));
  outbox.event(joint(1, TaskState::kStarted));
  outbox.event(task(2, TaskState::kStarted));
  outbox.event(joint(1, TaskState::kEnded));
  outbox.event(task(2, TaskState::kEnded));

  EXPECT_THAT(show(outbox.take()),
              ElementsAre("1 scheduled", "2 scheduled", "1 started", "2 started",
                          "forward 2 started", "1 ended", "2 ended"));
}

TEST(Outbox, OfTwoJointTasksEachHearsOfTheOtherAlsoOfItsEnd) {
  Outbox outbox;
  outbox.event(joint(1, TaskState::kRunning));
  outbox.event(joint(2, TaskState::kRunning));
  outbox.event(joint(1, TaskState::kEnded));
  outbox.event(joint(2, TaskState::kAborting));

  EXPECT_THAT(show(outbox.take()), ElementsAre("1 running", "2 running", "forward 2 running",
                                               "1 ended", "forward 1 ended", "2 aborting"));
}

TEST(Outbox, WhatWasLetGoIsUnderWayHereNoMore) {
  Outbox outbox;
  outbox.event(joint(1, TaskState::kRunning));
  outbox.let_go(TaskId{1});
  outbox.event(task(2, TaskState::kStarted));

  EXPECT_THAT(show(outbox.take()), ElementsAre("1 running", "2 started"));
}

}  // namespace
}  // namespace skein::executive
