// SPDX-License-Identifier: Apache-2.0
#include "book/wording.hpp"

#include <gtest/gtest.h>

namespace skein::supervisor {
namespace {

std::string named(const std::string& text) {
  return with_names(text, "task", [](std::uint64_t number) {
    return number == 104 ? std::string("the takeshot of goal 702") : std::string();
  });
}

TEST(WithNames, ReplacesEveryTaskThatHasAName) {
  EXPECT_EQ(named("task 104 must start while task 103 runs, but task 104 is late"),
            "the takeshot of goal 702 must start while task 103 runs, but the takeshot of goal 702 "
            "is late");
}

TEST(WithNames, ReplacesNothingElse) {
  for (const char* text : {"", "task", "task ", "tasks 104", "multitask 104", "task 1045",
                           "task 104th", "goal 104", "task 99999999999999999999999"})
    EXPECT_EQ(named(text), text);
}

TEST(WithNames, ReplacesAtBothEndsOfTheText) {
  EXPECT_EQ(named("task 104"), "the takeshot of goal 702");
  EXPECT_EQ(named("waits for task 104"), "waits for the takeshot of goal 702");
}

TEST(WithNames, LeavesWhatHasItsNameAlready) {
  const auto twice = [](const std::string& text) {
    return with_names(text, "goal", [](std::uint64_t number) {
      return "goal " + std::to_string(number) + " (perceive P1 60)";
    });
  };

  EXPECT_EQ(twice("goal 41 waits"), "goal 41 (perceive P1 60) waits");
  EXPECT_EQ(twice(twice("goal 41 waits for goal 42")), twice("goal 41 waits for goal 42"));
}

TEST(InWords, ATaskIsKnownByItsTypeAndItsGoal) {
  mission::ElementaryTask task;
  task.type = "perceive";
  task.origin = mission::GoalId(702);
  EXPECT_EQ(in_words(task), "the perceive of goal 702");
}

}  // namespace
}  // namespace skein::supervisor
