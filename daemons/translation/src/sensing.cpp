// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/sensing.hpp"

#include "skein/journal/record.hpp"

namespace skein::translation {

wire::Vector3 to_wire(const world::Vector3& v) { return {v.x(), v.y(), v.z()}; }

world::Vector3 from_wire(const wire::Vector3& v) { return {v.x, v.y, v.z}; }

wire::Telemetry to_wire(const world::Telemetry& telemetry) {
  const world::VehicleState& state = telemetry.state;
  wire::Telemetry sample;
  sample.uav = telemetry.uav;
  sample.position = to_wire(state.position);
  sample.velocity = to_wire(state.velocity);
  sample.heading = state.heading;
  sample.energy = state.energy;
  sample.airborne = state.airborne;
  sample.activity = state.activity;
  sample.failed = telemetry.failed;
  return sample;
}

world::Telemetry from_wire(const wire::Telemetry& sample) {
  return {sample.uav,
          {from_wire(sample.position), from_wire(sample.velocity), sample.heading, sample.energy,
           sample.airborne, sample.activity},
          MissionTime::nanoseconds(sample.header.mission_time),
          sample.failed};
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

std::vector<double> for_journal(const world::Vector3& v) {
  return journal::rounded(std::vector<double>{v.x(), v.y(), v.z()});
}

}  // namespace skein::translation
