// SPDX-License-Identifier: Apache-2.0
// ROS 2 messages about a team.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/ros2/messages.hpp"

namespace skein::ros2_out {

struct NarratorConfig {
  std::vector<std::string> uavs;
  world::GeodeticOrigin origin;  ///< of the local frame
  std::uint64_t epoch = 0;       ///< mission time zero [ns since 1970]
};

/// Names of the published topics, without "rt/". `uav` is a token (ros2::token_of).
std::string fix_topic(const std::string& uav);
std::string odometry_topic(const std::string& uav);
std::string battery_topic(const std::string& uav);
std::string tasks_topic(const std::string& uav);
inline constexpr const char* kAlarmsTopic = "skein/alarms";
inline constexpr const char* kDiagnosticsTopic = "diagnostics";
inline constexpr const char* kReplyTopic = "skein/reply";
/// The topic that is read.
inline constexpr const char* kMissionTopic = "skein/mission";
/// Frame id in headers: the local frame of the scenario, x east, y north, z up [m].
inline constexpr const char* kFrame = "map";

/// One message and its topic.
struct Told {
  std::string topic;
  ros2::Message message;
};

/// Publishes on arrival: the position of a UAV as a fix and as odometry, and its battery; states of
/// its tasks and goals; alarms. All but telemetry is repeated every second, since late subscribers
/// get no history; also every second a diagnostic of each UAV. Stamps are mission time from its
/// epoch on. Sans-IO; memory is one sample of each kind for each UAV.
class Narrator {
 public:
  /// Fails if two UAVs have the same ROS 2 token.
  static Result<Narrator, Failure> make(NarratorConfig config);

  std::vector<Told> hear(const wire::Sample& sample);
  /// Messages that are due; `steady` never decreases, `mission` is for stamps.
  std::vector<Told> turn(Duration steady, MissionTime mission);

 private:
  explicit Narrator(NarratorConfig config);
  std::vector<Told> locate(const wire::Telemetry& telemetry) const;
  ros2::Header header(MissionTime at) const;
  ros2::DiagnosticArray tasks_of(const wire::UavTasks& tasks, MissionTime at) const;
  ros2::DiagnosticArray alarms_of(const wire::GroundBoard& board, MissionTime at) const;
  ros2::DiagnosticArray health(MissionTime at) const;
  bool knows(const std::string& uav) const { return tokens_.contains(uav); }

  NarratorConfig config_;
  geodesy::GeodeticFrame frame_;
  std::map<std::string, std::string> tokens_;  ///< by UAV
  std::map<std::string, wire::UavBoard> boards_;
  std::map<std::string, wire::UavTasks> tasks_;
  std::map<std::string, std::vector<std::string>> failed_;  ///< devices, by UAV
  std::optional<wire::GroundBoard> ground_;
  std::optional<Duration> told_;  ///< when what is repeated was
};

}  // namespace skein::ros2_out
