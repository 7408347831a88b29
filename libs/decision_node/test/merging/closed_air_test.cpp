// SPDX-License-Identifier: Apache-2.0
// Who makes room, and where it goes on from there, beside closed air.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/world/crossing.hpp"
#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using testing::give_sweep;
using testing::goto_of;
using testing::last_had;
using testing::MergedTeam;

// Found by random missions (--mixed 300008): it stood 14 m beside smoke, found every way aside too
// near to it, and stayed for good.
TEST(MergingBesideClosedAir, WhoStandsNearClosedAirMakesRoomAwayFromIt) {
  world::Volume smoke{"smoke", {{3, -20}, {60, -20}, {60, 20}, {3, 20}}, 0, 100, {}};
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {-100, 0, 40}}}, 4, ContactPolicy::kContinue,
                  {smoke});
  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(team.notes("marvin"), ElementsAre(Field(&AirNoted::state, "aside")));
  EXPECT_LE(team.state("marvin").position.x(), 0);
}

// Found by random missions (--anything 800008): a plane around which air closed had no way out but
// the level one, in which another flew, and circled in and out of it for 40 s.
TEST(MergingBesideClosedAir, WhoIsInClosedAirLeavesItAboveWhoeverStaysInItsWay) {
  world::Volume smoke{"smoke", {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, 0, 200, {}};
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {60, 0, 40}}}, 4, ContactPolicy::kContinue,
                  {smoke});
  team.command("marvin", goto_of(7, {120, 0, 40}));
  team.run(1);
  EXPECT_THAT(team.begun("marvin"), ElementsAre(7U));
  EXPECT_EQ(last_had(team.notes("marvin")).raised, 12);
}

TEST(MergingBesideClosedAir, WhoIsInClosedAirLeavesItAsideWhenSomebodyStaysWhereItIsToGo) {
  world::Volume smoke{"smoke", {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, 0, 200, {}};
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {60, 0, 40}}}, 4, ContactPolicy::kContinue,
                  {smoke});
  team.cut("marvin", "heliv");
  team.command("marvin", goto_of(7, {60, 0, 40}));
  team.run(15);
  EXPECT_THAT(team.notes("marvin"), ::testing::Contains(Field(&AirNoted::state, "aside")));
  const world::Vector3& at = team.state("marvin").position;
  EXPECT_FALSE(world::crosses(smoke, 0, at, at)) << at.transpose();
}

// Found by random missions (--mixed 400069): its way was planned from where it stood before.
void expect_around_a_lid(const std::vector<double>& next_way) {
  world::Volume lid{"lid", {{20, -40}, {80, -40}, {80, 40}, {20, 40}}, 46, 200, {}};
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {-100, 0, 40}}}, 4, ContactPolicy::kContinue,
                  {lid});
  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(60);
  ASSERT_GT(team.state("marvin").position.z(), 46) << "it got out of the way upwards";

  give_sweep(team, "marvin", goto_of(9, next_way));
  for (int i = 0; i < 480 && !team.is_over("marvin", 9); ++i) {
    team.run(0.5);
    const world::Vector3& at = team.state("marvin").position;
    EXPECT_FALSE(world::crosses(lid, 0, at, at)) << at.transpose();
  }
  EXPECT_TRUE(team.is_over("marvin", 9));
}

TEST(MergingBesideClosedAir, WhoGotOutOfTheWayGoesAroundClosedAirToWhereItsNextWayBegins) {
  expect_around_a_lid({100, 0, 40});
}

// Found by missions of an outsider (70).
TEST(MergingBesideClosedAir, WhoGotOutOfTheWayGoesAroundClosedAirToASweepInPortionsToo) {
  expect_around_a_lid(
      {100, 0, 40, 100, 300, 40, 140, 300, 40, 140, 0, 40, 180, 0, 40, 180, 300, 40});
}

// Found by random missions (--mixed --merged 994015): a joint task had ended elsewhere than where
// the way home after it was planned from, and the leg to that led through smoke.
TEST(MergingBesideClosedAir, AWayOfThePlanThatBeginsElsewhereIsReachedAroundIt) {
  world::Volume smoke{"smoke", {{20, -40}, {80, -40}, {80, 40}, {20, 40}}, 0, 200, {}};
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {-300, 0, 40}}}, 4, ContactPolicy::kContinue,
                  {smoke});
  team.plan("marvin", goto_of(9, {100, 0, 40, 200, 0, 40}));
  for (int i = 0; i < 240 && !team.is_over("marvin", 9); ++i) {
    team.run(0.5);
    const world::Vector3& at = team.state("marvin").position;
    EXPECT_FALSE(world::crosses(smoke, 0, at, at)) << at.transpose();
  }
  EXPECT_TRUE(team.is_over("marvin", 9));
}

}  // namespace
}  // namespace skein::decision_node
