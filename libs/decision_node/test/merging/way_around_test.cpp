// SPDX-License-Identifier: Apache-2.0
// Ways past those for whom a motion waits, which are searched in jobs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using testing::before_a_wall;
using ::testing::ElementsAre;
using testing::goto_of;
using ::testing::IsEmpty;
using testing::MergedTeam;

TEST(WaysAround, OneSearchRunsAtATimeHoweverLongItTakes) {
  MergedTeam team = before_a_wall();
  team.withhold_searches(true);
  team.command("heliv", goto_of(7, {-100, 0, 40}));
  team.run(20);
  EXPECT_EQ(team.searches_asked_by("heliv"), 1);
  team.run(60);
  EXPECT_EQ(team.searches_asked_by("heliv"), 1);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());

  team.withhold_searches(false);
  team.run(60);

  EXPECT_THAT(team.begun("heliv"), ElementsAre(7));
  EXPECT_TRUE(team.is_over("heliv", 7));
}

TEST(WaysAround, AMotionThatIsOverIsNotFlownAlongAWayFoundForIt) {
  MergedTeam team = before_a_wall();
  team.withhold_searches(true);
  team.command("heliv", goto_of(7, {-100, 0, 40}));
  team.run(20);
  ASSERT_EQ(team.searches_asked_by("heliv"), 1);
  team.command("heliv", executive::Abort{executive::TaskId(7)});
  team.run(1);
  ASSERT_TRUE(team.is_over("heliv", 7));
  team.command("heliv", goto_of(8, {-100, 20, 40}));
  team.run(5);

  team.withhold_searches(false);
  team.run(8);

  EXPECT_THAT(team.begun("heliv"), IsEmpty()) << "the search was for the other's way";
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 8)) << "it has had its own searched";
}

}  // namespace
}  // namespace skein::decision_node
