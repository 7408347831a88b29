// SPDX-License-Identifier: Apache-2.0
// What a layer remembers of its tasks, against a book that never forgets anything.
#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/functional/status_memory.hpp"

namespace skein::functional {
namespace {

constexpr TaskState kAll[] = {TaskState::kScheduled, TaskState::kStarted, TaskState::kRunning,
                              TaskState::kAborting,  TaskState::kEnded,   TaskState::kAborted};

/// Everything that was told, for ever, and when each task became over.
class Book {
 public:
  void set(const Status& status) {
    const auto before = last_.find(status.id);
    const bool was_over = before != last_.end() && is_terminal(before->second.state) &&
                          is_kept(status.id);  // else it is news
    last_[status.id] = status;
    if (!was_over && is_terminal(status.state)) over_[status.id] = ++endings_;
  }
  const std::map<TaskId, Status>& all() const { return last_; }
  /// It is under way, or one of the last endings was its own.
  bool is_kept(TaskId task) const {
    return !is_terminal(last_.at(task).state) || endings_ - over_.at(task) < StatusMemory::kKept;
  }

 private:
  std::map<TaskId, Status> last_;
  std::map<TaskId, std::size_t> over_;  ///< the number of its last ending
  std::size_t endings_ = 0;
};

Status any_status(Random& random, std::uint64_t tasks) {
  Status status;
  status.id = TaskId(1 + random.below(tasks));
  status.state = kAll[random.below(std::size(kAll))];
  status.reason = "because " + std::to_string(random.below(1000));
  return status;
}

TEST(StatusMemoryLaws, TheStateOfEveryTaskIsKnownForEverAndItsReasonWhileItIsKept) {
  for (const std::uint64_t tasks : {10U, 300U, 2000U}) {
    Random random(tasks);
    StatusMemory memory;
    Book book;
    for (int step = 0; step < 6000; ++step) {
      const Status status = any_status(random, tasks);
      memory.set(status);
      book.set(status);
    }

    for (const auto& [task, told] : book.all()) {
      ASSERT_TRUE(memory.knows(task));
      const auto last = memory.last(task);
      ASSERT_TRUE(last.has_value());
      EXPECT_EQ(last->id, task);
      EXPECT_EQ(last->state, told.state) << "task " << task.value() << " of " << tasks;
      if (book.is_kept(task)) {
        EXPECT_EQ(last->reason, told.reason) << task.value();
      }
    }
    EXPECT_FALSE(memory.knows(TaskId(tasks + 1)));
  }
}

TEST(StatusMemoryLaws, ExactlyTheLastThatAreOverKeepTheirReasons) {
  StatusMemory memory;
  const std::uint64_t count = StatusMemory::kKept + 50;
  for (std::uint64_t i = 1; i <= count; ++i)
    memory.set({TaskId(i), i % 2 == 0 ? TaskState::kEnded : TaskState::kAborted, "reason"});

  for (std::uint64_t i = 1; i <= count; ++i) {
    const auto last = memory.last(TaskId(i));
    ASSERT_TRUE(last.has_value());
    EXPECT_EQ(last->state, i % 2 == 0 ? TaskState::kEnded : TaskState::kAborted) << i;
    EXPECT_EQ(last->reason, i > 50 ? "reason" : "") << i;
  }
}

TEST(StatusMemoryLaws, WhatIsNotedIsKnownAndNothingWasTold) {
  StatusMemory memory;
  memory.note(TaskId(7));
  EXPECT_TRUE(memory.knows(TaskId(7)));
  EXPECT_EQ(memory.last(TaskId(7)), std::nullopt);

  memory.set({TaskId(7), TaskState::kRunning, ""});
  memory.note(TaskId(7));
  EXPECT_EQ(memory.last(TaskId(7))->state, TaskState::kRunning) << "noted again is not forgotten";
}

TEST(StatusMemoryLaws, ATaskThatWasLetGoAndIsNotedAgainIsAsItEnded) {
  StatusMemory memory;
  memory.set({TaskId(1), TaskState::kAborted, "wind"});
  for (std::uint64_t i = 2; i <= StatusMemory::kKept + 1; ++i)
    memory.set({TaskId(i), TaskState::kEnded, ""});

  memory.note(TaskId(1));

  EXPECT_EQ(memory.last(TaskId(1))->state, TaskState::kAborted);
}

// ---- names ----

TEST(TaskStates, AreReadBackFromTheirNamesAndNothingElseIs) {
  for (const TaskState state : kAll) EXPECT_EQ(task_state_from(to_text(state)), state);
  for (const char* word : {"", "Ended", "ended ", "over", "?"})
    EXPECT_EQ(task_state_from(word), std::nullopt) << word;
}

TEST(TaskStates, AreOverInTwoOfSix) {
  std::vector<std::string> over;
  for (const TaskState state : kAll)
    if (is_terminal(state)) over.emplace_back(to_text(state));
  EXPECT_EQ(over, (std::vector<std::string>{"ended", "aborted"}));
}

TEST(AbortCauses, HaveNamesOfTheirOwn) {
  EXPECT_EQ(to_text(AbortCause::kOther), "other");
  EXPECT_EQ(to_text(AbortCause::kRequested), "requested");
  EXPECT_EQ(to_text(AbortCause::kNoAir), "no-air");
}

}  // namespace
}  // namespace skein::functional
