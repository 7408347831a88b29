// SPDX-License-Identifier: Apache-2.0
// What the vehicle refuses again and again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Doing refused(int task, int goal, double at, const std::string& why, const char* type = "goto") {
  Doing doing{task, type, goal, at, at, "aborted"};
  doing.reason = why;
  return doing;
}

TEST(Asked, AGoalMayAskThreeTimesForWhatIsRefused) {
  const auto times = [](int count) {
    Story story;
    for (int i = 0; i < count; ++i)
      story.does("marvin", refused(100 + i, 701, 10 + 40 * i, "too low by " + std::to_string(i)));
    return story.broken("asked");
  };

  EXPECT_THAT(times(3), IsEmpty());
  EXPECT_THAT(times(4), ElementsAre(HasSubstr("goal 701: asked: goto is asked for and refused for "
                                              "the 4th time: too low by 3")));
}

// Found by a storm (contingencies/air-closes-on-perception 308): it gave up leaving after three
// refusals, gave itself the same goal again, and asked five times in eight seconds.
TEST(Asked, WhoIsInClosedAirAsksForAsLongAsItIsThere) {
  Story story;
  story.goal("marvin", 701, "leave-closed-air", "under-way", 5);
  for (int i = 0; i < 6; ++i) story.does("marvin", refused(100 + i, 701, 10 + 10 * i, "no"));

  EXPECT_THAT(story.broken("asked"), IsEmpty());
}

TEST(Asked, OfWhatIsRefusedForDifferentReasonsThereMayBeMore) {
  Story story;
  for (int i = 0; i < 6; ++i)
    story.does("marvin", refused(100 + i, 701, 10 + i, i % 2 == 0 ? "no way" : "no energy"));

  EXPECT_THAT(story.broken("asked"), IsEmpty());
}

TEST(Asked, GoalsTogetherAskEightTimesAMinute) {
  const auto every = [](double seconds) {
    Story story;
    for (int i = 0; i < 12; ++i)
      story.does("marvin", refused(100 + i, 701 + i, 10 + seconds * i, "no", "land"));
    return story.broken("asked");
  };

  EXPECT_THAT(every(7.5), IsEmpty());
  EXPECT_THAT(every(7), ElementsAre(HasSubstr("more than 8 requests in a minute")));
}

TEST(Asked, AnOrderIsAReasonToAskOnceMore) {
  const auto ordered_at = [](double at) {
    Story story;
    for (int i = 0; i < 9; ++i)
      story.does("marvin", refused(100 + i, 701 + i, 10 + 7 * i, "no", "land"));
    story.decides("marvin", at, "0 user request", "mission 2 of an operator", "accepted");
    return story.broken("asked");
  };

  EXPECT_THAT(ordered_at(60), IsEmpty());
  EXPECT_THAT(ordered_at(70), ::testing::SizeIs(1)) << "it came later";
}

TEST(Asked, WhatRanAndWasLeftOffIsNotRefused) {
  Story story;
  for (int i = 0; i < 5; ++i) {
    Doing doing = refused(100 + i, 701, 10 + 10 * i, "engine trouble");
    doing.until += 5;
    story.does("marvin", doing);
  }

  EXPECT_THAT(story.broken("asked"), IsEmpty());
}

TEST(Asked, WhatWasToldToStopAsItBeganIsNotRefused) {
  Story story;
  for (int i = 0; i < 5; ++i)
    story.does("marvin", refused(100 + i, 701, 10 + 10 * i, "interrupted", "perceive"));

  EXPECT_THAT(story.broken("asked"), IsEmpty());
}

TEST(Asked, APlanIsMadeAnewADozenTimesAMinute) {
  const auto times = [](int count, const std::string& step) {
    Story story;
    for (int i = 0; i < count; ++i)
      story.decides("marvin", 10 + 2 * i, "6 repair: " + step, "cause", "plan 3, 4 tasks");
    return story.broken("asked");
  };

  EXPECT_THAT(times(12, "replan"), IsEmpty());
  EXPECT_THAT(times(13, "replan"), ElementsAre(HasSubstr("more than 12 plans in a minute")));
  EXPECT_THAT(times(13, "shift"), IsEmpty());
}

TEST(Fits, AWordOnATaskThatCannotBeSoBreaksIt) {
  Story story;
  story.says("marvin", 10, "status 'running' of task 301, which is aborting, does not fit");
  story.says("marvin", 11, "status 'started' of task 303, which is aborting, does not fit");
  story.says("marvin", 20, "status 'running' of task 302, which is running, does not fit")
      .says("marvin", 30, "in the air with nothing to do");

  EXPECT_THAT(story.broken("fits"),
              ElementsAre(HasSubstr("20.0 s, marvin: fits: status 'running' of task 302")));
}

}  // namespace
}  // namespace skein::laws::testing
