// SPDX-License-Identifier: Apache-2.0
// What operators give to a UAV, one by one, is theirs to answer for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/execution.hpp"
#include "testing/story.hpp"

namespace skein::laws {
namespace {

using testing::Doing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Story;

const std::string kWait = "{id: 5, type: wait, params: {duration: 20}}";

/// Marvin's operator gives it the task.
Story with(const std::string& task) {
  return Story("", "    - {step: fly, when: {time: 20}, do: [{plan: {uav: marvin, tasks: [" + task +
                       "]}}]}\n");
}

const Doing kRefused{5, "wait", 0, 30, 30, "aborted", "", {}, "motion task 100 is still active"};

TEST(ByHand, WhatTheVehicleRefusesOfItIsTheOperatorsError) {
  Story story;
  story.does("marvin", {100, "goto", 701, 5, 60}).does("marvin", kRefused);
  EXPECT_THAT(story.broken("one-motion"), ElementsAre(HasSubstr("asked for and refused")));

  Story by_hand = with(kWait);
  by_hand.does("marvin", {100, "goto", 701, 5, 60}).does("marvin", kRefused);
  EXPECT_THAT(by_hand.broken("one-motion"), IsEmpty());
}

TEST(ByHand, APlanThatIsInterruptedByItMayBeRefused) {
  const Doing planned{100, "goto", 701, 30, 30, "aborted", "", {}, "motion task 5 is still active"};
  Story story = with(kWait);
  story.does("marvin", {5, "wait", 0, 30, 60}).does("marvin", planned);
  EXPECT_THAT(story.broken("one-motion"), IsEmpty());
}

/// 701 is planned, and the executive has the operator's task, which does not begin.
Story behind(const std::string& task) {
  Story story = with(task);
  story.stands("marvin", 0, 300);
  story.line(journal::record_of(
      MissionTime::seconds(25), "marvin",
      journal::lines::Task{.uav = "marvin", .task = 5, .type = "wait", .state = "scheduled"}));
  story.goal("marvin", 701, "perceive P1 60", "received", 30)
      .goal("marvin", 701, "perceive P1 60", "planned", 31);
  return story;
}

TEST(ByHand, AGoalMayWaitForItIfThatIsSaid) {
  Story silent = behind(kWait);
  EXPECT_THAT(silent.broken("ends"), ElementsAre(HasSubstr("is planned at the end")));

  Story told = behind(kWait);
  told.says("marvin", 36, "goal 701 (perceive P1 60) waits for task 5 (wait)");
  EXPECT_THAT(told.broken("ends"), IsEmpty());
}

TEST(ByHand, AGoalIsNotForgottenWhileItGoesOn) {
  Story story = behind(kWait);
  story.does("marvin", {5, "wait", 0, 40, 290});
  EXPECT_THAT(story.broken("ends"), IsEmpty());
}

}  // namespace
}  // namespace skein::laws
