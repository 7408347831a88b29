// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/request.hpp"

#include <gtest/gtest.h>

#include "skein/mission/degree.hpp"

namespace skein::mission {
namespace {

TEST(Request, IsOfTheKindOfItsAlternative) {
  EXPECT_EQ(kind_of(executive::Start{}), RequestKind::kStart);
  EXPECT_EQ(kind_of(executive::Abort{}), RequestKind::kAbort);
  EXPECT_EQ(kind_of(executive::ProcessMessage{}), RequestKind::kProcessMessage);
  EXPECT_EQ(kind_of(executive::UpdateConditions{}), RequestKind::kUpdateConditions);
  EXPECT_EQ(kind_of(executive::Suppress{}), RequestKind::kSuppress);
  EXPECT_EQ(kind_of(UnitMission{}), RequestKind::kMission);
  EXPECT_EQ(kind_of(CancelGoals{}), RequestKind::kCancel);
  EXPECT_EQ(kind_of(ChangeDegree{}), RequestKind::kDegree);
  EXPECT_EQ(kind_of(ChangeWorld{}), RequestKind::kWorld);
}

TEST(Request, NamesTheTaskOrMissionThatItIsAbout) {
  executive::Start start;
  start.task.id = executive::TaskId(7);
  UnitMission mission;
  mission.id = MissionId(3);
  CancelGoals cancel;
  cancel.mission = MissionId(4);

  EXPECT_EQ(id_of(start), 7U);
  EXPECT_EQ(id_of(executive::Suppress{executive::TaskId(8)}), 8U);
  EXPECT_EQ(id_of(executive::UpdateConditions{executive::TaskId(9), {}, {}}), 9U);
  EXPECT_EQ(id_of(mission), 3U);
  EXPECT_EQ(id_of(cancel), 4U);
}

TEST(Request, AboutNothingInParticularNamesNone) {
  EXPECT_EQ(id_of(executive::ProcessMessage{"go"}), 0U);
  EXPECT_EQ(id_of(CancelGoals{{GoalId(5)}, MissionId(), true}), 0U);
  EXPECT_EQ(id_of(ChangeDegree{}), 0U);
  EXPECT_EQ(id_of(ChangeWorld{}), 0U);
}

TEST(Degree, SaysWhoPlansWhoExecutesAndWhoSynchronises) {
  EXPECT_TRUE(runs_at_ground(1));
  EXPECT_FALSE(runs_at_ground(2));
  EXPECT_FALSE(deliberates(3));
  EXPECT_TRUE(deliberates(4));
  EXPECT_FALSE(synchronises_directly(2, 3));
  EXPECT_FALSE(synchronises_directly(3, 2));
  EXPECT_TRUE(synchronises_directly(3, 4));
}

}  // namespace
}  // namespace skein::mission
