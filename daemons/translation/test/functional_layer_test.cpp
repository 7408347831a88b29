// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/functional_layer.hpp"

#include <gtest/gtest.h>

namespace skein::translation {
namespace {

using functional::Status;
using functional::TaskId;
using functional::TaskState;

std::optional<journal::Record> told(FunctionalLines& lines, std::uint64_t id, TaskState state) {
  return lines.line_of(MissionTime::seconds(1), "sim", "heliv", Status{TaskId(id), state, ""});
}

void note(FunctionalLines& lines, std::uint64_t id) {
  functional::Request request;
  request.id = TaskId(id);
  request.type = "goto";
  lines.note("heliv", request);
}

TEST(FunctionalLines, EachStateOfATaskIsALineOnceHoweverManyCameAfterIt) {
  FunctionalLines lines;
  constexpr std::uint64_t kTasks = 10 * FunctionalLines::kKept;
  for (std::uint64_t id = 1; id <= kTasks; ++id) {
    note(lines, id);
    ASSERT_TRUE(told(lines, id, TaskState::kRunning));
    ASSERT_TRUE(told(lines, id, TaskState::kEnded));
  }
  for (std::uint64_t id = 1; id <= kTasks; ++id) {
    note(lines, id);  // it is asked for once more, and answered as before
    ASSERT_FALSE(told(lines, id, TaskState::kEnded));
  }
}

TEST(FunctionalLines, ATaskThatIsUnderWayAgainIsALineAgain) {
  FunctionalLines lines;
  note(lines, 1);
  for (int times = 0; times < 3; ++times) {
    EXPECT_TRUE(told(lines, 1, TaskState::kRunning));
    EXPECT_TRUE(told(lines, 1, TaskState::kAborted));
  }
  for (std::uint64_t id = 2; id <= 3 * FunctionalLines::kKept; ++id)
    told(lines, id, TaskState::kEnded);
  EXPECT_FALSE(told(lines, 1, TaskState::kAborted));
  EXPECT_TRUE(told(lines, 1, TaskState::kRunning));
}

}  // namespace
}  // namespace skein::translation
