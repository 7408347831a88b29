// SPDX-License-Identifier: Apache-2.0
// Who has waited long for its air: what others do for it, and how long it waits for whom.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::Contains;
using testing::give_sweep;
using testing::goto_of;
using ::testing::IsEmpty;
using testing::MergedTeam;
using ::testing::Not;

std::vector<std::string> told_of_air(const std::vector<AirNoted>& notes) {
  std::vector<std::string> result;
  for (const AirNoted& one : notes) result.push_back(one.state);
  return result;
}

// Found by random missions (--merged 810003): it waited 22 min for one that waited for a third, so
// there was no circle. Marvin stays where its operator has put it, in heliv's way.
TEST(Pressing, WhoWaitsItselfWhereOneHasWaitedLongToComeGetsOutOfTheWay) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}, {"karma", {100, 200, 40}}});
  give_sweep(team, "karma", goto_of(7, {100, 0, 40}));
  team.run(20);
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(210);
  EXPECT_FALSE(team.is_over("karma", 7));
  EXPECT_THAT(told_of_air(team.notes("heliv")), Not(Contains("aside")));

  team.run(60);

  EXPECT_TRUE(team.is_over("karma", 7));
  EXPECT_THAT(told_of_air(team.notes("heliv")), Contains("aside"));
}

/// Marvin sweeps up and down one line for so many seconds, across the way that heliv wants.
MergedTeam beside_a_sweep(int seconds) {
  MergedTeam team({{"marvin", {0, -100, 40}}, {"heliv", {100, 0, 40}}}, 4);
  std::vector<double> way;
  for (int i = 0; i < seconds / 20; ++i)
    way.insert(way.end(), {0, i % 2 == 0 ? 100.0 : -100.0, 40});
  give_sweep(team, "marvin", goto_of(3, way));
  team.run(2);
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  return team;
}

// Found by random missions (--sweepers 911218): three times 6 min were less than a sweep.
TEST(Pressing, WhoWaitsForOneThatFliesGivesUpAfterEightMinutesOnly) {
  MergedTeam team = beside_a_sweep(440);
  team.run(400);
  EXPECT_THAT(team.begun("heliv"), IsEmpty());
  EXPECT_FALSE(team.is_over("heliv", 7));
  team.run(100);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(told_of_air(team.notes("heliv")), Contains("had"));
}

TEST(Pressing, AFlightWithoutEndIsNotWaitedForForEver) {
  MergedTeam team = beside_a_sweep(1000);
  team.run(500);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_THAT(told_of_air(team.notes("heliv")), Contains("given-up"));
}

}  // namespace
}  // namespace skein::decision_node
