// SPDX-License-Identifier: Apache-2.0
// Records in words.
#include "skein/journal/log_line.hpp"

#include <gtest/gtest.h>

namespace skein::journal {
namespace {

Record line(const std::string& kind) { return {MissionTime::seconds(1), "marvin", kind}; }

std::string said(const Record& record) {
  const auto line = log_line_of(record);
  return line ? line->text : "nothing";
}

TEST(LogLine, OfADecisionSaysWhatBecauseOfWhat) {
  EXPECT_EQ(said(line("decision")
                     .with("operator", "repair")
                     .with("cause", "late")
                     .with("outcome", "planned anew")),
            "decides repair because of late: planned anew");
}

TEST(LogLine, IsThereForRefusalsAndNotForWhatWentWell) {
  const auto request = [](bool accepted) {
    return line("request").with("request", "START").with("accepted", accepted).with("why", "busy");
  };
  EXPECT_EQ(said(request(false)), "refuses START: busy");
  EXPECT_EQ(said(request(true)), "nothing");
  EXPECT_EQ(said(line("command").with("state", "acknowledged")), "nothing");
  EXPECT_EQ(said(line("telemetry").with("uav", "marvin")), "nothing");
}

TEST(LogLine, OfAnExpectationThatIsNotMetIsAnError) {
  const auto told = log_line_of(
      line("expectation").with("name", "it lands").with("passed", false).with("seen", "never"));

  ASSERT_TRUE(told.has_value());
  EXPECT_EQ(told->level, Level::kError);
  EXPECT_EQ(told->text, "it lands: not met: never");
}

TEST(LogLine, OfATaskIsThereWhenItWasAborted) {
  const auto task = [](const char* state) {
    return line("task")
        .with("task", 4)
        .with("type", "goto")
        .with("state", state)
        .with("reason", "wind");
  };
  EXPECT_EQ(said(task("aborted")), "task 4 goto aborted: wind");
  EXPECT_EQ(said(task("ended")), "nothing");
}

}  // namespace
}  // namespace skein::journal
