// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/sensing.hpp"

#include "skein/journal/record.hpp"

namespace skein::translation {

wire::Vector3 to_wire(const world::Vector3& v) { return {v.x(), v.y(), v.z()}; }

world::Vector3 from_wire(const wire::Vector3& v) { return {v.x, v.y, v.z}; }

wire::Telemetry to_wire(const std::string& uav, const world::VehicleState& state) {
  wire::Telemetry telemetry;
  telemetry.uav = uav;
  telemetry.position = to_wire(state.position);
  telemetry.velocity = to_wire(state.velocity);
  telemetry.heading = state.heading;
  telemetry.energy = state.energy;
  telemetry.airborne = state.airborne;
  telemetry.activity = state.activity;
  return telemetry;
}

world::VehicleState from_wire(const wire::Telemetry& telemetry) {
  return {from_wire(telemetry.position),
          from_wire(telemetry.velocity),
          telemetry.heading,
          telemetry.energy,
          telemetry.airborne,
          telemetry.activity};
}

wire::PerceptionReport to_wire(const world::Perception& perception) {
  wire::PerceptionReport report;
  report.uav = perception.uav;
  report.device = perception.device;
  report.viewpoint = to_wire(perception.viewpoint);
  report.view_direction = to_wire(perception.direction);
  report.range = perception.range;
  report.aperture = perception.aperture;
  for (const world::Detection& seen : perception.detections) {
    report.detections.push_back({seen.kind, to_wire(seen.position), seen.spread, seen.confidence});
  }
  return report;
}

world::Perception from_wire(const wire::PerceptionReport& report) {
  world::Perception perception;
  perception.uav = report.uav;
  perception.device = report.device;
  perception.viewpoint = from_wire(report.viewpoint);
  perception.direction = from_wire(report.view_direction);
  perception.range = report.range;
  perception.aperture = report.aperture;
  perception.at = MissionTime::nanoseconds(report.header.mission_time);
  for (const wire::Detection& seen : report.detections) {
    perception.detections.push_back(
        {seen.kind, from_wire(seen.position), seen.spread, seen.confidence});
  }
  return perception;
}

std::vector<wire::Parameter> to_wire(const world::Parameters& parameters) {
  std::vector<wire::Parameter> result;
  for (const world::Parameter& one : parameters.all()) {
    result.push_back({one.name, one.text, one.numbers});
  }
  return result;
}

world::Parameters from_wire(const std::vector<wire::Parameter>& parameters) {
  std::vector<world::Parameter> result;
  for (const wire::Parameter& one : parameters) result.push_back({one.name, one.text, one.numbers});
  return world::Parameters(std::move(result));
}

std::vector<double> for_journal(const world::Vector3& v) {
  return journal::rounded(std::vector<double>{v.x(), v.y(), v.z()});
}

}  // namespace skein::translation
