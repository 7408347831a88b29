// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_record.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace skein::decision_node {
namespace {

MissionTime second(double seconds) { return MissionTime::seconds(seconds); }
Duration lasting(double seconds) { return Duration::seconds(seconds); }

TEST(RoleRecord, ATaskIsDoneForAsLongAsItRanAllTimesTogether) {
  RoleRecord record;
  EXPECT_EQ(record.done("w1"), lasting(0));

  record.runs("w1", second(10));
  EXPECT_EQ(record.stopped("w1", second(14)), lasting(4));
  EXPECT_EQ(record.stopped("w1", second(20)), lasting(0)) << "it did not run any more";
  record.begin_anew();
  record.runs("w1", second(30));
  EXPECT_EQ(record.stopped("w1", second(33)), lasting(3));

  EXPECT_EQ(record.done("w1"), lasting(7)) << "what was seen before another role counts";
  EXPECT_EQ(record.done("w2"), lasting(0));
}

TEST(RoleRecord, ATaskThatNeverRanTakesNoTime) {
  RoleRecord record;
  EXPECT_EQ(record.stopped("w1", second(14)), lasting(0));
  EXPECT_TRUE(record.done().empty());
}

TEST(RoleRecord, AReasonThatWasKnownBeforeATaskWasAbortedStands) {
  RoleRecord record;
  EXPECT_EQ(record.failure(), std::nullopt);

  record.failed("w1", "its camera is broken");
  record.aborted("w1", "on request");
  EXPECT_EQ(record.failure(), "w1: its camera is broken");

  record.failed("w1", "no way");
  EXPECT_EQ(record.failure(), "w1: no way");
  record.aborted("a1", "no air");
  EXPECT_EQ(record.failure(), "a1: no air") << "the first by name";
}

TEST(RoleRecord, WhatEndsAfterAllHasNotFailed) {
  RoleRecord record;
  record.failed("w1", "its camera is broken");
  record.failed("a1", "no air");

  record.ended("w1");

  EXPECT_EQ(record.failure(), "a1: no air");
}

TEST(RoleRecord, AnotherRoleHasNoFailuresOrTriesYet) {
  RoleRecord record;
  record.failed("w1", "no way");
  EXPECT_FALSE(record.fails_at_once_again("w1"));
  EXPECT_TRUE(record.is_tried_again("w1", lasting(5)));
  EXPECT_TRUE(record.is_tried_again("w1", lasting(5)));

  record.begin_anew();

  EXPECT_EQ(record.failure(), std::nullopt);
  EXPECT_FALSE(record.fails_at_once_again("w1"));
  EXPECT_TRUE(record.is_tried_again("w1", lasting(5)));
}

TEST(RoleRecord, WhatTheVehicleGaveUpIsTriedAgainTwice) {
  RoleRecord record;
  EXPECT_TRUE(record.is_tried_again("w1", lasting(5)));
  EXPECT_TRUE(record.is_tried_again("w1", lasting(5)));
  EXPECT_TRUE(record.is_tried_again("w2", lasting(5))) << "of each task for itself";
  EXPECT_FALSE(record.is_tried_again("w1", lasting(5)));

  record.asked_for("w1");
  EXPECT_TRUE(record.is_tried_again("w1", lasting(5))) << "the role wants it once more";
}

TEST(RoleRecord, WhatFailedAsItBeganIsNotTriedAgainAndIsNoTry) {
  RoleRecord record;
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(record.is_tried_again("w1", lasting(0.999)));
  EXPECT_TRUE(record.is_tried_again("w1", lasting(1)));
  EXPECT_TRUE(record.is_tried_again("w1", lasting(1)));
}

TEST(RoleRecord, TwoFailuresAtOnceInARowAreInVain) {
  RoleRecord record;
  EXPECT_FALSE(record.fails_at_once_again("w1"));
  record.did_not_fail_at_once("w1");
  EXPECT_FALSE(record.fails_at_once_again("w1")) << "it ran meanwhile";
  EXPECT_FALSE(record.fails_at_once_again("w2"));
  EXPECT_TRUE(record.fails_at_once_again("w1"));
}

/// main: before, loop: (inner, block: (deep)), after.
interaction::Automaton nested() {
  using interaction::Block;
  using interaction::Task;
  interaction::Automaton automaton;
  const auto main = *automaton.add({"main", 0, Block{}, "", 0});
  (void)automaton.add({"before", main, Task{}, "", 0});
  const auto loop = *automaton.add({"loop", main, Block{}, "", 0});
  (void)automaton.add({"inner", loop, Task{}, "", 0});
  const auto block = *automaton.add({"block", loop, Block{}, "", 0});
  (void)automaton.add({"deep", block, Task{}, "", 0});
  (void)automaton.add({"after", main, Task{}, "", 0});
  return automaton;
}

TEST(RoleRecord, WhatIsBegunAnewHasAnotherChanceWithAllInIt) {
  const interaction::Automaton automaton = nested();
  for (const auto& [again, left] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"loop", {"after", "before"}},
           {"block", {"after", "before", "inner"}},
           {"inner", {"after", "before", "deep"}},
           {"main", {}}}) {
    RoleRecord record;
    for (const char* one : {"before", "inner", "deep", "after"}) record.failed(one, "no way");

    record.forget_failures_in(again, automaton);

    std::vector<std::string> failed;
    for (auto why = record.failure(); why; why = record.failure()) {
      failed.push_back(why->substr(0, why->find(':')));
      record.forget_failures_in(failed.back(), automaton);
    }
    EXPECT_EQ(failed, left) << again;
  }
}

}  // namespace
}  // namespace skein::decision_node
