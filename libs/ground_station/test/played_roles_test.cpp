// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/played_roles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskState;
using testing::abort_of;
using testing::id;

PlayRole role(const std::string& uav, std::uint64_t task) {
  PlayRole play;
  play.uav = uav;
  play.task.id = mission::GoalId(task);
  return play;
}

SendRequest asking(const std::string& uav, Request request) {
  SendRequest asking;
  asking.uav = uav;
  asking.request = std::move(request);
  asking.asked_by = "anna";
  return asking;
}

PlayedTaskChanged changed(const std::string& uav, std::uint64_t task, TaskState state) {
  return {uav, {id(task), "joint:escort", state, "because"}};
}

TEST(PlayedRoles, StopForTheUavThatTheyArePlayedFor) {
  PlayedRoles roles;
  roles.play(role("marvin", 7));

  const auto stop = roles.stop("marvin", "it restarted");

  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->uav, "marvin");
  EXPECT_EQ(stop->task, std::nullopt);
  EXPECT_EQ(stop->why, "it restarted");
  EXPECT_FALSE(roles.stop("heliv", "it restarted").has_value());
}

TEST(PlayedRoles, AnAbortStopsTheOneThatItNames) {
  PlayedRoles roles;
  roles.play(role("marvin", 7));

  const auto stop = roles.stop(asking("marvin", abort_of(7)));

  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->task, id(7));
  EXPECT_EQ(stop->why, "interrupted by anna");
  EXPECT_FALSE(roles.stop(asking("marvin", abort_of(8))).has_value());
  EXPECT_FALSE(roles.stop(asking("heliv", abort_of(7))).has_value());
  EXPECT_FALSE(roles.stop(asking("marvin", testing::start_of(7))).has_value());
}

TEST(PlayedRoles, ArePlayedUntilTheirTaskIsOver) {
  PlayedRoles roles;
  roles.play(role("marvin", 7));
  roles.note(changed("marvin", 7, TaskState::kRunning));
  EXPECT_TRUE(roles.stop("marvin", "").has_value());

  roles.note(changed("marvin", 7, TaskState::kEnded));

  EXPECT_FALSE(roles.stop("marvin", "").has_value());
}

TEST(PlayedRoles, TellTheBoardOfTheirTaskAsOneAtTheGround) {
  PlayedRoles roles;

  const TaskEventReceived told = roles.note(changed("marvin", 7, TaskState::kAborted));

  EXPECT_EQ(told.uav, "marvin");
  EXPECT_EQ(told.task, id(7));
  EXPECT_EQ(told.type, "joint:escort");
  EXPECT_EQ(told.state, TaskState::kAborted);
  EXPECT_EQ(told.reason, "because");
  EXPECT_TRUE(told.at_ground);
}

}  // namespace
}  // namespace skein::ground_station
