// SPDX-License-Identifier: Apache-2.0
// What air has who was stopped in its takeoff or landing and circles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using testing::goto_of;
using testing::last_had;
using testing::MergedTeam;
using testing::takeoff_of;

// Found by missions of an outsider (352): the column down to the ground was its air still, and what
// is in the air of two already keeps neither from leaving.
TEST(Merging, WhoWasStoppedInItsLandingHasTheAirAtItsHeightOnly) {
  MergedTeam team({{"blimp", {0, 0, 180}}, {"heliv", {-300, 0, 40}}});
  team.command("blimp", testing::start_of(7, "land"));
  team.run(4);
  team.command("blimp", executive::Abort{executive::TaskId(7)});
  team.run(4);
  ASSERT_TRUE(team.is_over("blimp", 7));
  ASSERT_GT(team.state("blimp").position.z(), 100);

  team.command("heliv", goto_of(8, {300, 0, 40}));
  team.run(1);
  EXPECT_THAT(team.notes("heliv"), ElementsAre(Field(&AirNoted::state, "had")));
  EXPECT_EQ(last_had(team.notes("heliv")).raised, 0);
}

// Found by random missions (--mixed 13): it kept all the air of the takeoff in which it was
// stopped, for ever.
TEST(Merging, WhoCirclesSinceItWasStoppedMakesRoomForATakeoff) {
  MergedTeam team({{"blimp", {0, 0, 0}}, {"heliv", {30, 0, 0}}}, 4);
  team.command("blimp", takeoff_of(7, 70));
  team.run(4);
  team.command("blimp", executive::Abort{executive::TaskId(7)});
  team.run(2);
  ASSERT_TRUE(team.is_over("blimp", 7));
  team.command("heliv", takeoff_of(7, 40));
  team.run(90);
  EXPECT_TRUE(team.is_over("heliv", 7));
}

}  // namespace
}  // namespace skein::decision_node
