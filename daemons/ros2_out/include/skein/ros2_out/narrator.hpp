// SPDX-License-Identifier: Apache-2.0
// What a team looks like to programs of ROS 2.
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

/// The topics that are written, without "rt/". `uav` is a token (ros2::token_of).
std::string fix_topic(const std::string& uav);
std::string odometry_topic(const std::string& uav);
std::string battery_topic(const std::string& uav);
std::string tasks_topic(const std::string& uav);
inline constexpr const char* kAlarmsTopic = "skein/alarms";
inline constexpr const char* kDiagnosticsTopic = "diagnostics";
inline constexpr const char* kReplyTopic = "skein/reply";
/// That is read.
inline constexpr const char* kMissionTopic = "skein/mission";
/// Of the header: the local frame of the scenario, x east, y north, z up [m].
inline constexpr const char* kFrame = "map";

/// One message and where it goes.
struct Told {
  std::string topic;
  ros2::Message message;
};

/// As they come: where a UAV is, as a fix and as odometry, and its battery; what became of its
/// tasks and goals; alarms. All but telemetry is told again each second, since who joins late is
/// not told of what was before; once a second also how each UAV is, as a diagnostic. Stamps are
/// the mission's time from its epoch on. Sans-IO; memory is one sample of each kind for each UAV.
class Narrator {
 public:
  /// Two UAVs that ROS 2 cannot tell apart by their names are a failure.
  static Result<Narrator, Failure> make(NarratorConfig config);

  std::vector<Told> hear(const wire::Sample& sample);
  /// What is due; `steady` never decreases, `mission` is for stamps.
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
