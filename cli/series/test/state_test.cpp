// SPDX-License-Identifier: Apache-2.0
// What of a run is known at an instant.
#include "state.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein::series_tool {
namespace {

using journal::Record;

Record line(const std::string& node, const std::string& kind) {
  return {MissionTime::seconds(1), node, kind};
}

Record telemetry(const std::string& uav, std::vector<double> position) {
  return line("sim", "telemetry")
      .with("uav", uav)
      .with("position", std::move(position))
      .with("velocity", std::vector<double>{3, 4, 0})
      .with("heading", 0.5)
      .with("energy", 0.75)
      .with("airborne", true);
}

TEST(State, KnowsNothingOfWhomNothingWasHeard) {
  const State state;

  EXPECT_TRUE(std::isnan(state.uav("marvin").energy));
  EXPECT_TRUE(std::isnan(state.link("marvin", "ground")));
  EXPECT_TRUE(std::isnan(distance(state.uav("marvin"), state.uav("heliv"))));
}

TEST(State, HasWhatTheLastTelemetrySaid) {
  State state;
  state.see(telemetry("marvin", {0, 0, 0}));
  state.see(telemetry("marvin", {1, 2, 3}));
  state.see(telemetry("heliv", {1, 2, 15}));

  EXPECT_EQ(state.uav("marvin").position[1], 2);
  EXPECT_EQ(state.uav("marvin").airborne, 1);
  EXPECT_DOUBLE_EQ(distance(state.uav("marvin"), state.uav("heliv")), 12);
}

TEST(State, DoesNotTakeAPlaceThatIsNone) {
  State state;
  state.see(telemetry("marvin", {1, 2, 3}));
  state.see(telemetry("marvin", {9}));

  EXPECT_EQ(state.uav("marvin").position[0], 1);
}

TEST(State, CountsTasksThatAreUnderWayAndGoalsThatAreOpen) {
  State state;
  const auto task = [&](int id, const char* now) {
    state.see(line("marvin", "task").with("uav", "marvin").with("task", id).with("state", now));
  };
  const auto goal = [&](int id, const char* now) {
    state.see(line("marvin", "goal").with("uav", "marvin").with("goal", id).with("state", now));
  };
  task(1, "scheduled");
  task(2, "started");
  task(3, "running");
  task(3, "ended");
  goal(1, "received");
  goal(2, "planned");
  goal(2, "failed");

  EXPECT_EQ(state.uav("marvin").running.size(), 1U);
  EXPECT_EQ(state.uav("marvin").open.size(), 1U);
}

TEST(State, FollowsLinksBeliefsAlarmsAndMessages) {
  State state;
  state.see(line("sim", "link").with("from", "marvin").with("to", "ground").with("up", false));
  state.see(line("ground", "reach").with("peer", "marvin").with("reachable", true));
  state.see(line("marvin", "reach").with("peer", "ground").with("reachable", false));
  state.see(line("ground", "alarm").with("alarm", 1).with("state", "raised"));
  state.see(line("ground", "alarm").with("alarm", 2).with("state", "raised"));
  state.see(line("ground", "alarm").with("alarm", 1).with("state", "infirmed"));
  state.see(line("ground", "message").with("direction", "sent"));
  state.see(line("marvin", "message").with("direction", "received"));

  EXPECT_EQ(state.link("marvin", "ground"), 0);
  EXPECT_EQ(state.uav("marvin").reachable, 1);
  EXPECT_EQ(state.alarms(), 1);
  EXPECT_EQ(state.messages(), 1);
}

}  // namespace
}  // namespace skein::series_tool
