// SPDX-License-Identifier: Apache-2.0
// High-level tasks in words.
#include "skein/mission/high_level_task.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace skein::mission {
namespace {

TEST(Placement, IsReadBackFromItsWord) {
  for (const auto one : {Placement::kBest, Placement::kLast, Placement::kInTime, Placement::kTour,
                         Placement::kFirst}) {
    EXPECT_EQ(placement_from(to_text(one)), one);
  }
  EXPECT_EQ(placement_from("soon"), std::nullopt);
  EXPECT_EQ(placement_from(""), std::nullopt);
}

TEST(Placement, HasTheWordsOfTheScenarioFormat) {
  EXPECT_EQ(to_text(Placement::kInTime), "in-time");
  EXPECT_EQ(to_text(Placement::kFirst), "first");
}

TEST(GoalState, IsReadBackFromItsWordAndNoTwoShareOne) {
  std::set<std::string_view> words;
  for (int i = 0; i < static_cast<int>(GoalState::kCount); ++i) {
    const auto state = static_cast<GoalState>(i);

    EXPECT_EQ(goal_state_from(to_text(state)), state);
    EXPECT_TRUE(words.insert(to_text(state)).second);
  }
  EXPECT_EQ(goal_state_from("?"), std::nullopt);
}

TEST(GoalState, IsSettledWhenNothingMoreComesOfTheGoal) {
  EXPECT_TRUE(is_settled(GoalState::kAchieved));
  EXPECT_TRUE(is_settled(GoalState::kFailed));
  EXPECT_TRUE(is_settled(GoalState::kCancelled));
  EXPECT_FALSE(is_settled(GoalState::kUnderWay));
  EXPECT_FALSE(is_settled(GoalState::kHandedOver));
}

TEST(GoalState, AValueOutsideTheEnumerationHasNoWord) {
  EXPECT_EQ(to_text(GoalState::kCount), "?");
}

TEST(HighLevelTask, IsWrittenAsItsNameAndArguments) {
  HighLevelTask task{GoalId(702), "perform-detection", {}, {}};
  task.arguments = {std::string("Z2"), std::string("P2"), 300.0};

  EXPECT_EQ(to_text(task), "perform-detection Z2 P2 300");
}

TEST(HighLevelTask, WritesLocationsListsAndFractionsReadably) {
  HighLevelTask task{GoalId(1), "perform-tour", {}, {}};
  task.arguments = {world::Vector3(10, -20.5, 40), std::vector<std::string>{"P1", "P2"}, 0.1,
                    std::vector<std::string>{}};

  EXPECT_EQ(to_text(task), "perform-tour (10 -20.5 40) (P1 P2) 0.1 ()");
}

TEST(HighLevelTask, WritesItsTimeConstraintsInSeconds) {
  HighLevelTask task{GoalId(1), "general-land", {}, {}};
  task.time.start_after = MissionTime::seconds(120);
  task.time.end_before = MissionTime::seconds(600.5);

  EXPECT_EQ(to_text(task), "general-land [start-after 120, end-before 600.5]");
}

TEST(HighLevelTask, WritesItsBoundsAfterGoals) {
  HighLevelTask task{GoalId(1), "general-land", {}, {}};
  task.time.start_after = MissionTime::seconds(120);
  task.after = {{GoalId(701), false, Duration::seconds(10), Duration::seconds(60)},
                {GoalId(702), true, Duration::seconds(5), Duration::max()}};

  EXPECT_EQ(to_text(task),
            "general-land [start-after 120, start-after-goal 701 10 to 60, end-after-goal 702 5 or "
            "more]");
}

TEST(HighLevelTask, OddNumbersHaveATextToo) {
  HighLevelTask task{GoalId(1), "x", {}, {}};
  task.arguments = {std::numeric_limits<double>::infinity(), -0.0, 1e300};

  EXPECT_EQ(to_text(task), "x inf 0 1e+300");
}

TEST(TimeConstraints, AreAnyWhenOneBoundIsGiven) {
  TimeConstraints time;
  EXPECT_FALSE(time.any());

  time.end_after = MissionTime::seconds(1);

  EXPECT_TRUE(time.any());
}

}  // namespace
}  // namespace skein::mission
