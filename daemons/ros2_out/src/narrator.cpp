// SPDX-License-Identifier: Apache-2.0
#include "skein/ros2_out/narrator.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "skein/foundation/joined.hpp"
#include "skein/ros2/names.hpp"

namespace skein::ros2_out {

namespace {

using ros2::DiagnosticStatus;

constexpr Duration kAgain = Duration::milliseconds(1000);
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

std::string text_of(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

ros2::Quaternion about_z(double heading) {
  return {0, 0, std::sin(heading / 2), std::cos(heading / 2)};
}

/// What the vehicle sees of a velocity: x ahead, y left.
ros2::Vector3 seen_from(double heading, const wire::FloatVector3& v) {
  const double c = std::cos(heading), s = std::sin(heading);
  return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
}

std::uint8_t level_of(const wire::BoardTask& task) {
  if (task.lost) return DiagnosticStatus::kError;
  return task.state == wire::TaskState::kAborted ? DiagnosticStatus::kWarn : DiagnosticStatus::kOk;
}

std::uint8_t level_of(wire::AlarmState state) {
  if (state == wire::AlarmState::kConfirmed) return DiagnosticStatus::kError;
  return state == wire::AlarmState::kRaised ? DiagnosticStatus::kWarn : DiagnosticStatus::kOk;
}

DiagnosticStatus status_of(const std::string& uav, const wire::BoardTask& task) {
  DiagnosticStatus status{level_of(task),
                          uav + "/task " + std::to_string(task.id),
                          std::string(name_of(task.state)),
                          uav,
                          {}};
  status.values = {{"type", task.type},
                   {"since", text_of(static_cast<double>(task.since) / 1e9, 3)}};
  if (!task.reason.empty()) status.values.push_back({"reason", task.reason});
  if (task.at_ground) status.values.push_back({"executed by", "ground"});
  if (task.lost) status.values.push_back({"lost", "true"});
  return status;
}

}  // namespace

std::string fix_topic(const std::string& uav) { return "skein/" + uav + "/fix"; }
std::string odometry_topic(const std::string& uav) { return "skein/" + uav + "/odometry"; }
std::string battery_topic(const std::string& uav) { return "skein/" + uav + "/battery"; }
std::string tasks_topic(const std::string& uav) { return "skein/" + uav + "/tasks"; }

Result<Narrator, Failure> Narrator::make(NarratorConfig config) {
  std::map<std::string, std::string> by_token;
  for (const std::string& uav : config.uavs) {
    const auto [known, is_new] = by_token.try_emplace(ros2::token_of(uav), uav);
    if (!is_new) {
      return failure("UAVs '" + known->second + "' and '" + uav + "' would both be '" +
                     known->first + "' in ROS 2");
    }
  }
  return Narrator(std::move(config));
}

Narrator::Narrator(NarratorConfig config) : config_(std::move(config)), frame_(config_.origin) {
  for (const std::string& uav : config_.uavs) tokens_[uav] = ros2::token_of(uav);
}

ros2::Header Narrator::header(MissionTime at) const {
  const std::int64_t since = static_cast<std::int64_t>(config_.epoch) + at.count();
  return {{static_cast<std::int32_t>(since / 1'000'000'000),
           static_cast<std::uint32_t>(since % 1'000'000'000)},
          kFrame};
}

std::vector<Told> Narrator::hear(const wire::Sample& sample) {
  const auto at = MissionTime::nanoseconds(wire::header_of(sample).mission_time);
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&sample)) {
    if (!knows(telemetry->uav)) return {};
    failed_[telemetry->uav] = telemetry->failed;
    return locate(*telemetry);
  }
  if (const auto* tasks = std::get_if<wire::UavTasks>(&sample)) {
    if (!knows(tasks->uav)) return {};
    tasks_[tasks->uav] = *tasks;
    return {{tasks_topic(tokens_.at(tasks->uav)), tasks_of(*tasks, at)}};
  }
  if (const auto* ground = std::get_if<wire::GroundBoard>(&sample)) {
    const bool is_news = !ground_ || ground_->alarms != ground->alarms;
    ground_ = *ground;
    if (is_news) return {{kAlarmsTopic, alarms_of(*ground, at)}};
  }
  const auto* board = std::get_if<wire::UavBoard>(&sample);
  if (board != nullptr && knows(board->uav)) boards_[board->uav] = *board;
  return {};
}

std::vector<Told> Narrator::locate(const wire::Telemetry& telemetry) const {
  const std::string& uav = tokens_.at(telemetry.uav);
  const auto at = MissionTime::nanoseconds(telemetry.header.mission_time);
  const wire::FloatVector3& position = telemetry.position;
  const world::GeodeticPoint point = frame_.to_geodetic({position.x, position.y, position.z});
  ros2::NavSatFix fix;
  fix.header = header(at);
  fix.header.frame_id = uav;
  fix.latitude = point.latitude_degrees;
  fix.longitude = point.longitude_degrees;
  fix.altitude = point.altitude;
  ros2::Odometry odometry;
  odometry.header = header(at);
  odometry.child_frame_id = uav;
  odometry.pose.pose.position = {position.x, position.y, position.z};
  odometry.pose.pose.orientation = about_z(telemetry.heading);
  odometry.twist.twist.linear = seen_from(telemetry.heading, telemetry.velocity);
  ros2::BatteryState battery;
  battery.header = fix.header;
  battery.voltage = battery.temperature = battery.current = kUnknown;
  battery.charge = battery.capacity = battery.design_capacity = kUnknown;
  battery.percentage = telemetry.energy;
  battery.power_supply_status =
      telemetry.airborne ? ros2::BatteryState::kDischarging : ros2::BatteryState::kStatusUnknown;
  return {{fix_topic(uav), std::move(fix)},
          {odometry_topic(uav), std::move(odometry)},
          {battery_topic(uav), std::move(battery)}};
}

ros2::DiagnosticArray Narrator::tasks_of(const wire::UavTasks& tasks, MissionTime at) const {
  ros2::DiagnosticArray told{header(at), {}};
  for (const wire::BoardTask& task : tasks.tasks) told.status.push_back(status_of(tasks.uav, task));
  for (const wire::GoalEntry& goal : tasks.goals) {
    DiagnosticStatus status{DiagnosticStatus::kOk,
                            tasks.uav + "/goal " + std::to_string(goal.id),
                            std::string(name_of(goal.state)),
                            tasks.uav,
                            {}};
    status.values = {{"mission", std::to_string(goal.mission)}, {"statement", goal.statement}};
    if (!goal.why.empty()) status.values.push_back({"reason", goal.why});
    told.status.push_back(std::move(status));
  }
  return told;
}

ros2::DiagnosticArray Narrator::alarms_of(const wire::GroundBoard& board, MissionTime at) const {
  ros2::DiagnosticArray told{header(at), {}};
  for (const wire::BoardAlarm& alarm : board.alarms) {
    const wire::Vector3& p = alarm.position;
    const world::GeodeticPoint point = frame_.to_geodetic({p.x, p.y, p.z});
    DiagnosticStatus status{level_of(alarm.state),
                            "alarm " + std::to_string(alarm.id),
                            std::string(name_of(alarm.state)),
                            "",
                            {}};
    status.values = {{"belief", text_of(alarm.belief, 3)},
                     {"x", text_of(p.x, 1)},
                     {"y", text_of(p.y, 1)},
                     {"z", text_of(p.z, 1)},
                     {"radius", text_of(alarm.radius, 1)},
                     {"latitude", text_of(point.latitude_degrees, 7)},
                     {"longitude", text_of(point.longitude_degrees, 7)},
                     {"altitude", text_of(point.altitude, 1)},
                     {"views", std::to_string(alarm.views)}};
    told.status.push_back(std::move(status));
  }
  return told;
}

// What is wrong on board counts for more than that it is not heard.
ros2::DiagnosticArray Narrator::health(MissionTime at) const {
  ros2::DiagnosticArray told{header(at), {}};
  for (const auto& [uav, board] : boards_) {
    const auto failed = failed_.find(uav);
    const bool works = failed == failed_.end() || failed->second.empty();
    DiagnosticStatus status;
    status.name = "skein/" + uav;
    status.hardware_id = uav;
    status.level = !works            ? DiagnosticStatus::kError
                   : board.reachable ? DiagnosticStatus::kOk
                                     : DiagnosticStatus::kStale;
    status.message = !works            ? "does not work: " + joined(failed->second, ", ")
                     : board.reachable ? "in contact"
                                       : "not heard";
    status.values = {{"degree", std::to_string(board.degree)},
                     {"airborne", board.airborne ? "true" : "false"},
                     {"energy", text_of(board.energy, 3)},
                     {"commands not answered", std::to_string(board.waiting)}};
    if (!board.holder.empty()) status.values.push_back({"in hand of", board.holder});
    told.status.push_back(std::move(status));
  }
  return told;
}

std::vector<Told> Narrator::turn(Duration steady, MissionTime mission) {
  if (told_ && steady - *told_ < kAgain) return {};
  told_ = steady;
  std::vector<Told> told;
  for (const auto& [uav, tasks] : tasks_) {
    told.push_back({tasks_topic(tokens_.at(uav)), tasks_of(tasks, mission)});
  }
  if (ground_) told.push_back({kAlarmsTopic, alarms_of(*ground_, mission)});
  told.push_back({kDiagnosticsTopic, health(mission)});
  return told;
}

}  // namespace skein::ros2_out
