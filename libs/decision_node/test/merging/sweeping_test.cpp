// SPDX-License-Identifier: Apache-2.0
// A sweep gets its air portion by portion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using executive::TaskState;
using ::testing::Each;
using ::testing::ElementsAre;
using testing::give_sweep;
using testing::goto_of;
using testing::last_had;
using testing::MergedTeam;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// Lanes of 300 m to the north and back, 40 m beside each other, from where marvin stands.
std::vector<double> lanes(int count) {
  std::vector<double> points;
  for (int i = 0; i < count; ++i) {
    const double x = 40.0 * i;
    const double first = i % 2 == 0 ? 0 : 300;
    for (const double one : {x, first, 40.0, x, 300 - first, 40.0}) points.push_back(one);
  }
  return points;
}

MergedTeam over_lanes(const std::string& sweeper = "marvin") {
  return MergedTeam({{sweeper, {0, 0, 40}}, {"heliv", {280, -60, 40}}});
}

TEST(Sweeping, ASweepHasTheAirOfAPortionOnlyAndOthersFlyThroughTheRest) {
  MergedTeam team = over_lanes();
  give_sweep(team, "marvin", goto_of(3, lanes(8)));
  team.run(5);
  team.command("heliv", goto_of(7, {280, 360, 40}));
  team.run(60);
  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_FALSE(team.is_over("marvin", 3));
  EXPECT_EQ(last_had(team.notes("heliv")).raised, 0);
  team.run(300);
  EXPECT_TRUE(team.is_over("marvin", 3));
}

TEST(Sweeping, ASweepInPortionsIsOneMotionToItsExecutive) {
  MergedTeam team = over_lanes();
  give_sweep(team, "marvin", goto_of(3, lanes(8)));
  team.run(330);
  EXPECT_THAT(team.begun("marvin"), SizeIs(::testing::Gt(3U)));
  EXPECT_THAT(team.notices("marvin"), Each(StartsWith("in the air with nothing under way")))
      << "after it";
  std::vector<TaskState> states;
  for (const executive::TaskEvent& one : team.events("marvin"))
    if (one.id == functional::TaskId(3)) states.push_back(one.state);
  EXPECT_THAT(states, ElementsAre(TaskState::kScheduled, TaskState::kStarted, TaskState::kRunning,
                                  TaskState::kEnded));
}

TEST(Sweeping, ASweepThroughFreeAirNeverStops) {
  for (const std::string sweeper : {"marvin", "blimp"}) {
    MergedTeam team = over_lanes(sweeper);
    give_sweep(team, sweeper, goto_of(3, lanes(8)));
    team.run(2);
    int stops = 0;
    for (int tenths = 0; tenths < 2600; ++tenths) {
      team.run(0.1);
      stops += team.state(sweeper).velocity.norm() < 0.1 ? 1 : 0;
    }
    EXPECT_LE(stops, 6) << sweeper;  // tenths of a second: a status, and the next portion
  }
}

TEST(Sweeping, ASweepWaitsBetweenTwoPortionsForWhoStaysInTheNext) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {200, 150, 40}}});
  give_sweep(team, "marvin", goto_of(3, lanes(8)));
  team.run(300);
  EXPECT_FALSE(team.is_over("marvin", 3));
  EXPECT_THAT(team.notes("marvin").back().waits_for, ElementsAre("heliv to leave"));
  EXPECT_LT(team.state("marvin").position.x(), 200 - 2);
  team.command("heliv", goto_of(7, {200, 450, 40}));
  team.run(200);
  EXPECT_TRUE(team.is_over("marvin", 3));
  EXPECT_NEAR(team.state("marvin").position.x(), 280, 0.5);
}

TEST(Sweeping, ASweepThatIsInterruptedInAPortionStopsThere) {
  MergedTeam team = over_lanes();
  give_sweep(team, "marvin", goto_of(3, lanes(8)));
  team.run(20);
  team.command("marvin", executive::Abort{functional::TaskId(3)});
  team.run(5);
  EXPECT_TRUE(team.is_over("marvin", 3));
  EXPECT_EQ(team.events("marvin").back().state, TaskState::kAborted);
  EXPECT_LT(team.state("marvin").velocity.norm(), 0.1);
  const auto flights = team.begun("marvin").size();
  team.run(100);
  EXPECT_EQ(team.begun("marvin").size(), flights);
}

TEST(Sweeping, ASweepThatIsInterruptedBetweenTwoPortionsEnds) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {200, 150, 40}}});
  give_sweep(team, "marvin", goto_of(3, lanes(8)));
  team.run(300);
  team.command("marvin", executive::Abort{functional::TaskId(3)});
  team.run(1);
  EXPECT_TRUE(team.is_over("marvin", 3));
  team.command("heliv", goto_of(7, {200, 450, 40}));
  team.run(60);
  EXPECT_LT(team.state("marvin").position.x(), 200 - 2);
}

// Marvin's lanes lead over where heliv waits for its own, and the reverse.
TEST(Sweeping, TwoSweepsThatWaitForEachOtherGetOutOfEachOthersWay) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {280, 0, 40}}}, 4);
  give_sweep(team, "marvin", goto_of(3, lanes(8)));
  std::vector<double> back;
  const std::vector<double> all = lanes(8);
  for (std::size_t i = all.size(); i >= 3; i -= 3)
    back.insert(back.end(), all.begin() + static_cast<std::ptrdiff_t>(i) - 3,
                all.begin() + static_cast<std::ptrdiff_t>(i));
  give_sweep(team, "heliv", goto_of(7, back));
  team.run(900);
  EXPECT_TRUE(team.is_over("marvin", 3));
  EXPECT_TRUE(team.is_over("heliv", 7));
}

}  // namespace
}  // namespace skein::decision_node
