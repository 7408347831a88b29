// SPDX-License-Identifier: Apache-2.0
#include "skein/functional/status_memory.hpp"

#include <gtest/gtest.h>

#include <string>

namespace skein::functional {
namespace {

Status status(std::uint64_t id, TaskState state, std::string reason = {}) {
  return {TaskId(id), state, std::move(reason)};
}

TEST(StatusMemory, KnowsWhatIsNotedBeforeAnythingIsTold) {
  StatusMemory memory;
  memory.note(TaskId(7));

  EXPECT_TRUE(memory.knows(TaskId(7)));
  EXPECT_FALSE(memory.knows(TaskId(8)));
  EXPECT_EQ(memory.last(TaskId(7)), std::nullopt);
}

TEST(StatusMemory, KnowsHowATaskEndedHoweverManyCameAfterIt) {
  StatusMemory memory;
  memory.set(status(1, TaskState::kRunning));
  for (std::uint64_t id = 2; id <= 10'000; ++id) {
    memory.note(TaskId(id));
    memory.set(status(id, TaskState::kRunning));
    const bool ends = id % 3 != 0;
    memory.set(status(id, ends ? TaskState::kEnded : TaskState::kAborted, ends ? "" : "engine"));
  }

  for (std::uint64_t id = 2; id <= 10'000; ++id) {
    memory.note(TaskId(id));
    ASSERT_TRUE(memory.knows(TaskId(id)));
    ASSERT_EQ(memory.last(TaskId(id))->state,
              id % 3 != 0 ? TaskState::kEnded : TaskState::kAborted);
  }
  EXPECT_EQ(memory.last(TaskId(1))->state, TaskState::kRunning) << "it is not over";
  EXPECT_EQ(memory.last(TaskId(9'999))->reason, "engine");
  EXPECT_EQ(memory.last(TaskId(3))->reason, "");
}

TEST(StatusMemory, ATaskThatIsOverAndToldOfAgainIsOverOnce) {
  StatusMemory memory;
  for (int times = 0; times < 1'000; ++times) memory.set(status(1, TaskState::kEnded));
  memory.set(status(2, TaskState::kAborted, "wind"));

  EXPECT_EQ(memory.last(TaskId(1))->state, TaskState::kEnded);
  EXPECT_EQ(memory.last(TaskId(2))->reason, "wind");
}

TEST(StatusMemory, ATaskThatIsUnderWayAgainIsKeptUntilItIsOverAgain) {
  StatusMemory memory;
  memory.set(status(1, TaskState::kAborted, "forgotten"));
  memory.set(status(1, TaskState::kRunning));
  for (std::uint64_t id = 2; id <= 1'000; ++id) memory.set(status(id, TaskState::kEnded));
  EXPECT_EQ(memory.last(TaskId(1))->state, TaskState::kRunning);

  memory.set(status(1, TaskState::kEnded));
  memory.set(status(1, TaskState::kRunning));
  memory.set(status(1, TaskState::kEnded));
  for (std::uint64_t id = 1'001; id <= 2'000; ++id) memory.set(status(id, TaskState::kEnded));
  EXPECT_EQ(memory.last(TaskId(1))->state, TaskState::kEnded);
}

TEST(StatusMemory, ForgetsAll) {
  StatusMemory memory;
  for (std::uint64_t id = 1; id <= 1'000; ++id) memory.set(status(id, TaskState::kEnded));

  memory.forget();

  EXPECT_FALSE(memory.knows(TaskId(1)));
  EXPECT_FALSE(memory.knows(TaskId(1'000)));
}

}  // namespace
}  // namespace skein::functional
