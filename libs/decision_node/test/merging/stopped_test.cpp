// SPDX-License-Identifier: Apache-2.0
// What air has who was stopped in its takeoff or landing and circles, and who refuses to move.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using testing::give_sweep;
using testing::goto_of;
using testing::last_had;
using testing::MergedTeam;
using testing::takeoff_of;
using testing::Vector3;

/// Of the motions of a UAV, as they were journaled.
std::string air_states(MergedTeam& team, const std::string& uav) {
  std::string states;
  for (const AirNoted& note : team.notes(uav)) states += note.state + " ";
  return states;
}

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

/// A blimp that was stopped after 100 m of a way of 800 m, and a helicopter that is to cross it.
MergedTeam stopped_on_its_way(const Vector3& heliv) {
  MergedTeam team({{"blimp", {0, 0, 40}}, {"heliv", heliv}});
  team.circle("blimp");
  team.command("blimp", goto_of(7, {800, 0, 40}));
  team.run(10);
  team.command("blimp", executive::Abort{executive::TaskId(7)});
  team.run(1);
  return team;
}

// Found by random missions (--anything --clean 990014): an operator's plan had stopped it, and its
// whole way was kept from two others for 2,000 s.
TEST(Merging, WhoCirclesSinceItWasStoppedHasTheAirThereOnly) {
  MergedTeam team = stopped_on_its_way({600, -200, 40});
  ASSERT_TRUE(team.is_over("blimp", 7));
  give_sweep(team, "heliv", goto_of(8, {600, 200, 40}));
  team.run(2);
  EXPECT_EQ(air_states(team, "heliv"), "waits ") << "nobody knows yet where it circles";

  team.run(20);

  EXPECT_EQ(air_states(team, "heliv"), "waits had ");
}

TEST(Merging, WhoCirclesSinceItWasStoppedKeepsTheAirAroundItsCircle) {
  MergedTeam team = stopped_on_its_way({100, -200, 40});
  give_sweep(team, "heliv", goto_of(8, {100, 200, 40}));
  team.run(60);

  EXPECT_EQ(air_states(team, "heliv"), "waits ");
}

// Found by random missions (--merged 944017): a functional layer that aborted each flight was given
// another one every 5 s.
TEST(Merging, AVehicleThatRefusesToIsAskedLessAndLessOften) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}}, 4);
  team.refuse("marvin", true);
  team.command("heliv", goto_of(7, {0, 0, 40}));
  team.run(70);
  EXPECT_THAT(team.given("marvin"), ::testing::AllOf(::testing::Ge(3), ::testing::Le(4)))
      << "after 10, 20, 40 s";
  EXPECT_FALSE(team.is_over("heliv", 7));

  team.refuse("marvin", false);
  team.run(80 + 30);

  EXPECT_TRUE(team.is_over("heliv", 7));
}

// Found by random missions (--anything 989005): one whose engine had failed, and who waited for
// others that waited for it, was given a flight aside every 1.4 s.
TEST(Merging, AVehicleThatRefusesToIsAskedLessAndLessOftenInACircleToo) {
  MergedTeam team({{"marvin", {-100, 0, 40}}, {"heliv", {100, 0, 40}}});
  team.refuse("heliv", true);
  team.refuse("marvin", true);
  give_sweep(team, "marvin", goto_of(7, {100, 0, 40}));
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));

  team.run(70);

  for (const char* uav : {"marvin", "heliv"})
    EXPECT_LE(team.given(uav), 4) << uav << ": after 10, 20, 40 s";
  EXPECT_GE(team.given("marvin") + team.given("heliv"), 3);
}

}  // namespace
}  // namespace skein::decision_node
