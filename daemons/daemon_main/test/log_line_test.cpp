// SPDX-License-Identifier: Apache-2.0
#include "log_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::daemon_main {
namespace {

using journal::Record;
using ::testing::HasSubstr;

Record record(const std::string& kind) { return {MissionTime::seconds(570.25), "karma", kind}; }

TEST(LogLine, IsASentenceWithTheMissionTimeBeforeIt) {
  EXPECT_EQ(log_line(record("task")
                         .with("uav", "karma")
                         .with("task", 102)
                         .with("type", "goto")
                         .with("state", "running")),
            "[0:09:30] goto 102 running");
}

TEST(LogLine, SaysInBracketsWhatTheSentenceHasNoPlaceFor) {
  EXPECT_EQ(
      log_line(record("task")
                   .with("uav", "karma")
                   .with("task", 103)
                   .with("type", "takeshot")
                   .with("state", "aborted")
                   .with("device", "ir")
                   .with("target", std::vector<double>{1, 2.5, 0.12345})
                   .with("reason", "engine trouble")),
      "[0:09:30] takeshot 103 aborted (device ir, target 1 2.5 0.123, reason engine trouble)");
}

TEST(LogLine, NamesTheUavWhenAnotherNodeWritesOfIt) {
  Record one(MissionTime(), "ground", "task");
  one.with("uav", "karma").with("task", 1).with("type", "wait").with("state", "started");

  EXPECT_EQ(log_line(one), "[0:00:00] wait 1 started (uav karma)");
}

TEST(LogLine, HasWordsForWhatIsTrueOrNot) {
  EXPECT_EQ(log_line(record("reach").with("peer", "ground").with("reachable", false)),
            "[0:09:30] ground cannot be reached");
  EXPECT_EQ(log_line(record("link").with("from", "a").with("to", "b").with("up", true)),
            "[0:09:30] radio from a to b up");
  EXPECT_EQ(log_line(record("object").with("active", true)), "[0:09:30] object (active yes)");
}

TEST(LogLine, OfAKindWithoutASentenceTellsEveryField) {
  EXPECT_EQ(log_line(record("expired").with("slot", "Command").with("to", "x").with("sequence", 7)),
            "[0:09:30] expired (slot Command, to x, sequence 7)");
}

TEST(LogLine, LeavesOutPlacesOfFieldsThatAreNotThere) {
  EXPECT_EQ(log_line(record("request").with("request", "UPDATE-COND").with("accepted", true)),
            "[0:09:30] UPDATE-COND: accepted");
  EXPECT_EQ(log_line(record("dropped")
                         .with("slot", "PlanBoard")
                         .with("origin", "node 0")
                         .with("field", "")
                         .with("why", "not CDR version 1")),
            "[0:09:30] PlanBoard of node 0 refused: not CDR version 1");
}

}  // namespace
}  // namespace skein::daemon_main
