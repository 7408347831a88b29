// SPDX-License-Identifier: Apache-2.0
#include "skein/ros2_out/narrator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace skein::ros2_out {
namespace {

using ros2::DiagnosticArray;
using ros2::DiagnosticStatus;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint64_t kEpoch = 1'116'493'200'000'000'000;  // 2005-05-19T09:00:00Z

Narrator a_narrator(std::vector<std::string> uavs = {"marvin", "heli-2"}) {
  return Narrator::make({std::move(uavs), {40, -8, 200}, kEpoch}).value();
}

template <class S>
S stamped(S sample, double at) {
  sample.header.mission_time = MissionTime::seconds(at).count();
  return sample;
}

wire::Telemetry telemetry(const char* uav) {
  wire::Telemetry sample;
  sample.uav = uav;
  sample.position = {100, 0, 50};
  sample.velocity = {0, 3, 1};
  sample.heading = std::numbers::pi_v<float> / 2;
  sample.energy = 0.75;
  sample.airborne = true;
  return sample;
}

wire::UavTasks tasks() {
  wire::UavTasks board;
  board.uav = "marvin";
  board.tasks = {{3, "goto", wire::TaskState::kRunning, "", 1'500'000'000, false, false},
                 {4, "land", wire::TaskState::kAborted, "wind", 0, false, true}};
  wire::GoalEntry goal;
  goal.id = 12;
  goal.mission = 1;
  goal.statement = "perceive P1";
  board.goals = {goal};
  return board;
}

wire::GroundBoard ground(wire::AlarmState state) {
  wire::GroundBoard board;
  wire::BoardAlarm alarm;
  alarm.id = 1;
  alarm.state = state;
  alarm.belief = 0.875;
  alarm.position = {0, 0, 0};
  board.alarms = {alarm};
  return board;
}

std::vector<std::string> topics(const std::vector<Told>& told) {
  std::vector<std::string> names;
  for (const Told& one : told) names.push_back(one.topic);
  return names;
}

template <class M>
M only(const std::vector<Told>& told, const std::string& topic) {
  for (const Told& one : told) {
    if (one.topic == topic) return std::get<M>(one.message);
  }
  ADD_FAILURE() << "nothing on " << topic;
  return {};
}

TEST(Narrator, TellsTelemetryAsAFixOdometryAndBattery) {
  Narrator narrator = a_narrator();

  const auto told = narrator.hear(stamped(telemetry("heli-2"), 1.25));

  EXPECT_THAT(topics(told),
              ElementsAre("skein/heli_2/fix", "skein/heli_2/odometry", "skein/heli_2/battery"));
  const auto fix = only<ros2::NavSatFix>(told, "skein/heli_2/fix");
  EXPECT_EQ(fix.header.stamp, (ros2::Time{1'116'493'201, 250'000'000}));
  EXPECT_EQ(fix.header.frame_id, "heli_2");
  EXPECT_NEAR(fix.latitude, 40, 1e-5);
  EXPECT_NEAR(fix.longitude, -8 + 100 / (111'320 * std::cos(40 * std::numbers::pi / 180)), 1e-5);
  EXPECT_NEAR(fix.altitude, 250, 0.01);
  const auto battery = only<ros2::BatteryState>(told, "skein/heli_2/battery");
  EXPECT_EQ(battery.percentage, 0.75F);
  EXPECT_TRUE(std::isnan(battery.voltage));
}

// REP 103: x ahead, y left; the twist of odometry is in the frame of the vehicle.
TEST(Narrator, OdometryHasTheTwistInTheFrameOfTheVehicle) {
  const auto told = a_narrator().hear(stamped(telemetry("marvin"), 1));

  const auto odometry = only<ros2::Odometry>(told, "skein/marvin/odometry");
  EXPECT_EQ(odometry.header.frame_id, "map");
  EXPECT_EQ(odometry.child_frame_id, "marvin");
  EXPECT_EQ(odometry.pose.pose.position, (ros2::Vector3{100, 0, 50}));
  constexpr double kSingle = 1e-6;  // telemetry's figures are in single precision
  EXPECT_NEAR(odometry.pose.pose.orientation.z, std::sqrt(0.5), kSingle);
  EXPECT_NEAR(odometry.pose.pose.orientation.w, std::sqrt(0.5), kSingle);
  EXPECT_NEAR(odometry.twist.twist.linear.x, 3, kSingle);
  EXPECT_NEAR(odometry.twist.twist.linear.y, 0, kSingle);
  EXPECT_NEAR(odometry.twist.twist.linear.z, 1, kSingle);
}

TEST(Narrator, TellsTasksAndGoalsWithTheirStates) {
  const auto told = a_narrator().hear(stamped(tasks(), 2));

  const auto array = only<DiagnosticArray>(told, "skein/marvin/tasks");
  ASSERT_EQ(array.status.size(), 3U);
  EXPECT_EQ(array.status[0].name, "marvin/task 3");
  EXPECT_EQ(array.status[0].message, "running");
  EXPECT_EQ(array.status[0].level, DiagnosticStatus::kOk);
  EXPECT_EQ(array.status[0].values,
            (std::vector<ros2::KeyValue>{{"type", "goto"}, {"since", "1.500"}}));
  EXPECT_EQ(array.status[1].level, DiagnosticStatus::kWarn);
  EXPECT_EQ(array.status[1].values[2], (ros2::KeyValue{"reason", "wind"}));
  EXPECT_EQ(array.status[1].values[3], (ros2::KeyValue{"executed by", "ground"}));
  EXPECT_EQ(array.status[2].name, "marvin/goal 12");
  EXPECT_EQ(array.status[2].values[1], (ros2::KeyValue{"statement", "perceive P1"}));
}

TEST(Narrator, TellsAlarmsWhenTheyChange) {
  Narrator narrator = a_narrator();

  const auto raised = narrator.hear(stamped(ground(wire::AlarmState::kRaised), 1));
  const auto same = narrator.hear(stamped(ground(wire::AlarmState::kRaised), 2));
  const auto confirmed = narrator.hear(stamped(ground(wire::AlarmState::kConfirmed), 3));

  EXPECT_THAT(same, IsEmpty());
  EXPECT_EQ(only<DiagnosticArray>(raised, kAlarmsTopic).status[0].level, DiagnosticStatus::kWarn);
  const auto array = only<DiagnosticArray>(confirmed, kAlarmsTopic);
  EXPECT_EQ(array.status[0].level, DiagnosticStatus::kError);
  EXPECT_EQ(array.status[0].message, "confirmed");
  EXPECT_EQ(array.status[0].values[0], (ros2::KeyValue{"belief", "0.875"}));
  EXPECT_EQ(array.status[0].values[5], (ros2::KeyValue{"latitude", "40.0000000"}));
}

TEST(Narrator, TellsEachSecondAgainWhatLateJoinersMissed) {
  Narrator narrator = a_narrator();
  narrator.hear(stamped(tasks(), 1));
  narrator.hear(stamped(ground(wire::AlarmState::kRaised), 1));

  EXPECT_THAT(topics(narrator.turn(Duration::seconds(10), MissionTime::seconds(2))),
              ElementsAre("skein/marvin/tasks", "skein/alarms", "diagnostics"));
  EXPECT_THAT(narrator.turn(Duration::seconds(10.9), MissionTime::seconds(3)), IsEmpty());
  EXPECT_THAT(topics(narrator.turn(Duration::seconds(11), MissionTime::seconds(4))),
              ElementsAre("skein/marvin/tasks", "skein/alarms", "diagnostics"));
}

TEST(Narrator, SaysHowEachUavIs) {
  Narrator narrator = a_narrator();
  wire::UavBoard board;
  board.uav = "marvin";
  board.degree = 3;
  board.reachable = true;
  board.holder = "ada";
  narrator.hear(stamped(board, 1));
  const auto level = [&](double at) {
    const auto told = narrator.turn(Duration::seconds(at), MissionTime::seconds(at));
    return only<DiagnosticArray>(told, kDiagnosticsTopic).status.at(0).level;
  };

  EXPECT_EQ(level(1), DiagnosticStatus::kOk);
  board.reachable = false;
  narrator.hear(stamped(board, 2));
  EXPECT_EQ(level(2), DiagnosticStatus::kStale);
  wire::Telemetry broken = telemetry("marvin");
  broken.failed = {"engine"};
  narrator.hear(stamped(broken, 3));
  EXPECT_EQ(level(3), DiagnosticStatus::kError);
}

TEST(Narrator, DoesNotTellOfStrangers) {
  EXPECT_THAT(a_narrator().hear(stamped(telemetry("stranger"), 1)), IsEmpty());
}

TEST(Narrator, TwoUavsThatRosCannotTellApartAreAFailure) {
  const auto made = Narrator::make({{"uav-1", "uav_1"}, {}, 0});

  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().why, "UAVs 'uav-1' and 'uav_1' would both be 'uav_1' in ROS 2");
}

}  // namespace
}  // namespace skein::ros2_out
