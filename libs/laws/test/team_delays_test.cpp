// SPDX-License-Identifier: Apache-2.0
// Times between tasks of a team.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// 12 is to begin 60 to 300 s after 11 ends; marvin ends that at 100 s.
struct Between : Story {
  Between() {
    team::GlobalTask first, then;
    first.task.id = mission::GoalId(11);
    then.task.id = mission::GoalId(12);
    then.after = {first.task.id};
    then.task.after = {{first.task.id, false, Duration::seconds(60), Duration::seconds(300)}};
    global_mission({first, then});
    team("marvin", 25, 11, 1, "begun").team("marvin", 100, 11, 1, "done");
  }
  std::vector<std::string> begun_at(double goes, double looks, const std::string& end) {
    team("heliv", goes - 1, 12, 2, "begun");
    does("heliv", {21, "gotoxyz", 12, goes, looks});
    does("heliv", {22, "perceive", 12, looks, looks + 20});
    team("heliv", looks + 20, 12, 2, end);
    return broken("team-delays");
  }
};

TEST(TeamDelays, EveryPartOfTheOtherBeginsBetweenTheBounds) {
  EXPECT_THAT(Between().begun_at(161, 399, "done"), IsEmpty());
}

TEST(TeamDelays, NoPartBeginsTooEarly) {
  EXPECT_THAT(
      Between().begun_at(150, 200, "done"),
      ElementsAre(HasSubstr("gotoxyz of task 12 began 50.0 s after task 11, not 60.0 to 300.0 s")));
  EXPECT_THAT(Between().begun_at(150, 200, "put-back"), SizeIs(1));
}

TEST(TeamDelays, WhatBeginsTooLateIsNotDone) {
  EXPECT_THAT(Between().begun_at(380, 410, "done"),
              ElementsAre(HasSubstr("perceive of task 12 began 310.0 s after task 11")));
  EXPECT_THAT(Between().begun_at(380, 410, "put-back"), IsEmpty());
}

TEST(TeamDelays, NothingBeginsBeforeTheFirstIsDone) {
  EXPECT_THAT(Between().begun_at(40, 60, "done"), SizeIs(2));
}

}  // namespace
}  // namespace skein::laws::testing
