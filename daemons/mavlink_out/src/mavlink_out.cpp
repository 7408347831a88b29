// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_out/mavlink_out.hpp"

#include <algorithm>
#include <utility>

#include "skein/journal/log_line.hpp"

namespace skein::mavlink_out {
namespace {

world::Vector3 vector_of(const wire::FloatVector3& from) { return {from.x, from.y, from.z}; }

Severity severity_of(journal::Level level) {
  switch (level) {
    case journal::Level::kDebug:
      return Severity::kDebug;
    case journal::Level::kInfo:
      return Severity::kInfo;
    case journal::Level::kWarning:
      return Severity::kWarning;
    case journal::Level::kError:
      return Severity::kError;
  }
  return Severity::kInfo;
}

}  // namespace

Result<AnnouncerConfig, Failure> announcer_config_of(const scenario::Scenario& scenario,
                                                     double geoid) {
  if (scenario.uavs.size() > Announcer::kMostVehicles)
    return failure("more than " + std::to_string(Announcer::kMostVehicles) +
                   " UAVs: MAVLink has no more system ids");
  AnnouncerConfig config;
  config.origin = scenario.world.origin;
  config.geoid = geoid;
  config.rate = scenario.rate;
  const world::Terrain terrain(scenario.world.terrain);
  for (const scenario::UavSpec& uav : scenario.uavs)
    config.vehicles.push_back(
        {uav.name, uav.model.kind, terrain.elevation(uav.start.x(), uav.start.y())});
  return config;
}

Result<std::unique_ptr<MavlinkOut>, Failure> MavlinkOut::open(const std::string& address,
                                                              AnnouncerConfig config) {
  auto link = mavlink_node::Link::open(address);
  if (!link) return tl::unexpected(link.error());
  return std::unique_ptr<MavlinkOut>(new MavlinkOut(std::move(*link), std::move(config)));
}

MavlinkOut::MavlinkOut(std::unique_ptr<mavlink_node::Link> link, AnnouncerConfig config)
    : link_(std::move(link)), announcer_(std::move(config)) {}

void MavlinkOut::sees(const wire::Sample& sample) {
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&sample)) take_telemetry(*telemetry);
  if (const auto* tasks = std::get_if<wire::UavTasks>(&sample)) take_decisions(*tasks);
}

void MavlinkOut::take_telemetry(const wire::Telemetry& telemetry) {
  announcer_.hear({telemetry.uav, MissionTime::nanoseconds(telemetry.header.mission_time),
                   vector_of(telemetry.position), vector_of(telemetry.velocity), telemetry.heading,
                   telemetry.energy, telemetry.airborne, !telemetry.failed.empty()},
                  now_);
  auto& known = failed_[telemetry.uav];
  for (const std::string& device : telemetry.failed)
    if (std::find(known.begin(), known.end(), device) == known.end())
      announcer_.say(telemetry.uav, Severity::kError, device + " does not work");
  known = telemetry.failed;
}

void MavlinkOut::take_decisions(const wire::UavTasks& tasks) {
  std::uint64_t& told = decided_[tasks.uav];
  for (const wire::BoardDecision& one : tasks.decisions) {
    if (one.number <= told || one.outcome.empty()) continue;
    told = one.number;
    announcer_.say(tasks.uav, Severity::kInfo,
                   "decides " + one.applied + " because of " + one.cause + ": " + one.outcome);
  }
}

void MavlinkOut::sees(const journal::Record& record) {
  if (const auto line = journal::log_line_of(record))
    announcer_.say(std::string(record.text("uav")), severity_of(line->level), line->text);
}

void MavlinkOut::turn(const node::DaemonState& state) {
  now_ = state.now.steady;
  (void)link_->receive();  // udpin learns from it where the other station is
  for (const mavlink::Bytes& bytes : announcer_.turn(now_)) link_->send(bytes);
}

}  // namespace skein::mavlink_out
