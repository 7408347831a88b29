// SPDX-License-Identifier: Apache-2.0
// Who waits for its partners at a meeting makes room for others, and does at its place what is to
// be done there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using testing::give_sweep;
using testing::goto_of;
using ::testing::IsEmpty;
using testing::MergedTeam;

std::vector<std::string> states(const std::vector<AirNoted>& notes) {
  std::vector<std::string> result;
  for (const AirNoted& one : notes) result.push_back(one.state);
  return result;
}

mission::ElementaryTask task_of(std::uint64_t id, const std::string& type) {
  mission::ElementaryTask task;
  task.id = executive::TaskId(id);
  task.type = type;
  return task;
}

/// A wait that ends with task 9, and that: marvin meets heliv.
std::vector<mission::ElementaryTask> wait_until_met(const std::string& how) {
  mission::ElementaryTask wait = task_of(8, "wait"), ends = task_of(9, how);
  wait.stop = {{mission::DependenceKind::kEnded, ends.id}};
  ends.dependences = {{mission::DependenceKind::kRunning, wait.id}};
  ends.duration = {Duration(), Duration::seconds(600)};
  if (how == "synchronise")
    ends.synchronisation = executive::Synchronisation{501, {"heliv"}, {"marvin"}, {}};
  return {wait, ends};
}

// Found by random missions (--anything --clean 994002): it waited in the air for a partner, who
// waited for a third to leave, who waited to land beside the first, until the end.
TEST(MeetingRoom, WhoWaitsForAPartnerToComeMakesRoom) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}}, 4);
  team.let_waits_last();
  team.plan("marvin", wait_until_met("synchronise"));
  team.run(2);
  ASSERT_THAT(team.begun("marvin"), ElementsAre(8U));

  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(40);

  EXPECT_TRUE(team.is_over("heliv", 7));
  EXPECT_FALSE(team.is_over("marvin", 8)) << "its partner has not come";
  EXPECT_THAT(states(team.notes("marvin")), ElementsAre("aside"));
}

TEST(MeetingRoom, WhoWaitsUntilItHasLookedStays) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}}, 4);
  team.let_waits_last();
  team.plan("marvin", wait_until_met("takeshot"));
  team.run(2);
  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(40);

  EXPECT_FALSE(team.is_over("heliv", 7));
  EXPECT_THAT(team.notes("marvin"), IsEmpty());
}

/// Marvin has made room for heliv, which has left again; then marvin's plan is a wait, and to look
/// at something meanwhile.
MergedTeam after_room_was_made(bool looks) {
  MergedTeam team({{"marvin", {0, 0, 40}}, {"heliv", {100, 0, 40}}}, 4);
  give_sweep(team, "heliv", goto_of(7, {0, 0, 40}));
  team.run(40);
  team.command("heliv", goto_of(17, {-200, 0, 40}));
  team.run(60);
  team.let_waits_last();
  mission::ElementaryTask wait = task_of(8, "wait"), look = task_of(9, "takeshot");
  wait.duration = {Duration::seconds(20), Duration::seconds(20)};
  look.dependences = {{mission::DependenceKind::kRunning, wait.id}};
  look.stop = {{mission::DependenceKind::kEnded, wait.id}};
  if (looks)
    team.plan("marvin", std::vector{wait, look});
  else
    team.plan("marvin", std::vector{wait});
  team.run(30);
  return team;
}

TEST(MeetingRoom, WhoLooksAtSomethingWhileItWaitsComesBackBefore) {
  MergedTeam team = after_room_was_made(true);
  EXPECT_THAT(states(team.notes("marvin")), ElementsAre("aside", "back"));
  EXPECT_LT((team.state("marvin").position - testing::Vector3(0, 0, 40)).norm(), 2);
  EXPECT_EQ(team.begun("marvin").back(), 9U);
}

TEST(MeetingRoom, WhoOnlyWaitsDoesSoWhereItIs) {
  MergedTeam team = after_room_was_made(false);
  EXPECT_THAT(states(team.notes("marvin")), ElementsAre("aside"));
  EXPECT_EQ(team.begun("marvin").back(), 8U);
}

}  // namespace
}  // namespace skein::decision_node
