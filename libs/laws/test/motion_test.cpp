// SPDX-License-Identifier: Apache-2.0
// One motion at a time, and none under a task of another goal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/truth.hpp"
#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(OneMotion, TwoMotionsOverlap) {
  Story story;
  story.does("marvin", {100, "goto", 701, 5, 60}).does("marvin", {101, "wait", 702, 30, 90});

  EXPECT_THAT(story.broken("one-motion"),
              ElementsAre(HasSubstr("wait 101 of goal 702 begins while goto 100")));
}

TEST(OneMotion, OneAfterTheOtherIsFine) {
  Story story;
  story.does("marvin", {100, "goto", 701, 5, 60}).does("marvin", {101, "wait", 702, 60, 90});

  EXPECT_THAT(story.broken("one-motion"), IsEmpty());
}

TEST(OneMotion, WhatTheVehicleBeginsWithLaterIsFine) {
  Story story;
  story.does("marvin", {100, "land", 701, 5, 60, "aborted"})
      .does("marvin", {101, "wait", 0, 50, 90, "ended", "", {}, "", 60});

  EXPECT_THAT(story.broken("one-motion"), IsEmpty());
}

// Found by storms (handover/synchronised, seeds 60, 447 and 671).
// An operator's landing, given while a takeoff was being interrupted for a way.
TEST(OneMotion, WhatIsGivenFirstAndBegunLastIsFine) {
  Story story;
  story.does("marvin", {1, "takeoff", 0, 9, 14, "aborted", "", {}, "", 10})
      .does("marvin", {3, "goto", 0, 14, 17, "aborted", "", {}, "", 15})
      .does("marvin", {6, "land", 0, 9, 40, "ended", "", {}, "", 18});

  EXPECT_THAT(story.broken("one-motion"), IsEmpty());
}

TEST(OneMotion, WhatTheGroundStartedOutOfReachIsUnderWayOnceItIsStartedOnBoard) {
  Story story;
  story.starts_unheard("heliv", 145, 203, "goto")
      .does("heliv", {900, "wait", 0, 193, 200})
      .does("heliv", {203, "goto", 803, 199, 245, "ended", "", {}, "", 202});

  EXPECT_THAT(story.broken("one-motion"), IsEmpty());
}

// Found by missions of an outsider: taken in hand, and given back with an interruption, at 0.39 s.
TEST(OneMotion, WhatTheVehicleEndedBeforeTheGroundHandedItUpIsOver) {
  namespace lines = journal::lines;
  const auto broken = [](int in_hand, double vehicle_ends) {
    Story story;
    const auto task = [&](double at, const char* state) {
      story.line(journal::record_of(
          MissionTime::seconds(at), "marvin",
          lines::Task{.uav = "marvin", .task = 7, .type = "goto", .state = state}));
    };
    const auto truth = [&](double at, const char* state) {
      story.line(journal::record_of(
          MissionTime::seconds(at), "sim",
          lines::Functional{.uav = "marvin", .task = 7, .type = "goto", .state = state}));
    };
    task(11, "started");
    truth(11, "running");
    story.degree("marvin", 0, 2).degree("marvin", 100, in_hand).degree("marvin", 117, 3);
    truth(vehicle_ends, "aborted");
    story.does("marvin", {900, "wait", 0, 117, 118.1, "aborted"});
    task(118.2, "aborted");
    return story.broken("one-motion");
  };

  EXPECT_THAT(broken(1, 117), IsEmpty());
  EXPECT_THAT(broken(1, 118), SizeIs(1)) << "the vehicle had not";
  EXPECT_THAT(broken(2, 117), SizeIs(1)) << "it was on board all the time";
}

TEST(OneMotion, WhatTheGroundStartedOutOfReachOverlapsAsAnyOnBoard) {
  Story story;
  story.starts_unheard("heliv", 145, 203, "goto")
      .does("heliv", {900, "wait", 0, 193, 200})
      .does("heliv", {203, "goto", 803, 196, 245});

  EXPECT_THAT(story.broken("one-motion"), ElementsAre(HasSubstr("goto 203")));
}

TEST(Held, NoMotionBeginsUnderAPerceptionOfAnotherGoal) {
  Story story;
  story.does("marvin", {100, "takeshot", 701, 5, 125, "ended", "visible"})
      .does("marvin", {101, "goto", 702, 60, 90});

  EXPECT_THAT(story.broken("held"),
              ElementsAre(HasSubstr("goto 101 of goal 702 begins while takeshot 100 of goal 701")));
}

TEST(Held, TheOwnMotionAndWhatIsStoppedThenAreFine) {
  Story story;
  story.does("marvin", {100, "takeshot", 701, 5, 60.5, "aborted", "visible"});
  story.does("marvin", {101, "goto", 701, 20, 55}).does("marvin", {102, "goto", 702, 60, 90});

  EXPECT_THAT(story.broken("held"), IsEmpty());
}

// Found by random missions (--partners 800203): a takeoff ended, the joint task that waited for it
// was started, and the wait was asked for, in one instant.
TEST(Held, ASafeWaitThatIsAskedForWhileTheOtherIsStartedIsFine) {
  const auto begins = [](const std::string& motion, int goal, double at) {
    Story story;
    story.does("marvin", {100, "joint:monitoring-with-relay", 701, 5, 125});
    return story.does("marvin", {101, motion, goal, at, 90}).broken("held");
  };

  EXPECT_THAT(begins("wait", 0, 5), IsEmpty());
  EXPECT_THAT(begins("wait", 0, 6), SizeIs(1)) << "it knew";
  EXPECT_THAT(begins("wait", 702, 5), SizeIs(1)) << "of its plan";
  EXPECT_THAT(begins("goto", 0, 5), SizeIs(1)) << "it moves";
}

}  // namespace
}  // namespace skein::laws::testing
