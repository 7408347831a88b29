// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/mission_progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using mission::GoalState;
using mission::GoalStatus;
using mission::MissionId;
using testing::at;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::only;
using Changes = std::vector<MissionProgress::Change>;

GoalStatus goal(std::uint64_t number, GoalState state) {
  GoalStatus goal;
  goal.id = mission::GoalId(number);
  goal.mission = MissionId(2);
  goal.state = state;
  return goal;
}

std::vector<GoalState> states(const Changes& changes) {
  std::vector<GoalState> out;
  for (const GoalChanged& change : only<GoalChanged>(changes)) out.push_back(change.state);
  return out;
}

std::vector<MissionStage> stages(const Changes& changes) {
  std::vector<MissionStage> out;
  for (const MissionChanged& change : only<MissionChanged>(changes)) out.push_back(change.stage);
  return out;
}

struct Progress : ::testing::Test {
  Changes take(const std::vector<GoalStatus>& told, std::optional<MissionTime> when = {}) {
    return progress.take("marvin", goals, told, when);
  }
  MissionProgress progress;
  std::vector<GoalStatus> goals;  ///< as shown
};

TEST_F(Progress, TellsEachStateOfAGoalOnce) {
  EXPECT_THAT(states(take({goal(1, GoalState::kReceived)})), ElementsAre(GoalState::kReceived));
  EXPECT_THAT(states(take({goal(1, GoalState::kReceived)})), IsEmpty());

  EXPECT_THAT(states(take({goal(1, GoalState::kAchieved)})), ElementsAre(GoalState::kAchieved));
  EXPECT_EQ(goals.at(0).state, GoalState::kAchieved);
}

TEST_F(Progress, WhatWasTrueEarlierThanWhatIsShownIsNotTaken) {
  take({goal(1, GoalState::kAchieved)}, at(5));

  EXPECT_THAT(take({goal(1, GoalState::kReceived)}, at(4)), IsEmpty());

  EXPECT_EQ(goals.at(0).state, GoalState::kAchieved);
}

TEST_F(Progress, AMissionIsAchievedOnceAllItsGoalsAre) {
  EXPECT_THAT(stages(take({goal(1, GoalState::kAchieved), goal(2, GoalState::kReceived)})),
              IsEmpty());

  EXPECT_THAT(stages(take({goal(1, GoalState::kAchieved), goal(2, GoalState::kAchieved)})),
              ElementsAre(MissionStage::kAchieved));
}

TEST_F(Progress, AMissionHasFailedWithOneOfItsGoalsButOnlyWhenAllAreOver) {
  EXPECT_THAT(stages(take({goal(1, GoalState::kFailed), goal(2, GoalState::kReceived)})),
              IsEmpty());

  EXPECT_THAT(stages(take({goal(1, GoalState::kFailed), goal(2, GoalState::kAchieved)})),
              ElementsAre(MissionStage::kFailed));
}

TEST_F(Progress, AMissionOfCancelledGoalsNeitherFailedNorWasAchieved) {
  EXPECT_THAT(stages(take({goal(1, GoalState::kCancelled)})), IsEmpty());
}

TEST_F(Progress, TellsEachStageOfAMissionOnceBetweenRestarts) {
  EXPECT_TRUE(progress.stage("marvin", MissionId(2), MissionStage::kPlanned).has_value());
  EXPECT_FALSE(progress.stage("marvin", MissionId(2), MissionStage::kPlanned).has_value());
  EXPECT_TRUE(progress.stage("marvin", MissionId(2), MissionStage::kRefused).has_value());
  EXPECT_TRUE(progress.stage("marvin", MissionId(3), MissionStage::kPlanned).has_value());

  progress.restart();

  EXPECT_TRUE(progress.stage("marvin", MissionId(2), MissionStage::kPlanned).has_value());
}

}  // namespace
}  // namespace skein::ground_station
