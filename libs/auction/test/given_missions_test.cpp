// SPDX-License-Identifier: Apache-2.0
// How a mission comes to the holder of the token.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/lone_member.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

using TeamMemberTest = testing::LoneMember;

TEST_F(TeamMemberTest, WhoHearsNoHolderSaysItsMissionsToAll) {
  TeamMember one = member(), other = member();
  one.handle(MissionGiven{{MissionNumber(7), {}}}, at(0));
  other.handle(Tick{}, at(0));

  const auto said_by_one = said<Status>(one.handle(Tick{}, *one.next_wakeup()));
  ASSERT_THAT(said_by_one, SizeIs(2));
  EXPECT_THAT(said_by_one[0].missions, SizeIs(1));
  EXPECT_THAT(said<Status>(other.handle(Tick{}, *other.next_wakeup())), IsEmpty())
      << "it was given none";
}

TEST_F(TeamMemberTest, WhatAnotherWasGivenIsSaidToTheHolder) {
  TeamMember one = member();
  Status heard;
  heard.missions = {{MissionNumber(7), {}}};
  EXPECT_EQ(count<Store>(one.handle(from(2, heard), at(1))), 1U);
  EXPECT_EQ(count<Store>(one.handle(from(2, heard), at(2))), 0U) << "it is known";

  const auto reported = said<Status>(one.handle(from(1, Beat{3, 4, granted()}), at(3)));
  EXPECT_THAT(reported.at(0).missions, SizeIs(1));
}

}  // namespace
}  // namespace skein::auction
