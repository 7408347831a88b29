// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/sensing.hpp"

#include "skein/journal/record.hpp"

namespace skein::translation {

wire::Vector3 to_wire(const world::Vector3& v) { return {v.x(), v.y(), v.z()}; }

world::Vector3 from_wire(const wire::Vector3& v) { return {v.x, v.y, v.z}; }

wire::FloatVector3 to_float_wire(const world::Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

world::Vector3 from_wire(const wire::FloatVector3& v) { return {v.x, v.y, v.z}; }

wire::Telemetry to_wire(const world::Telemetry& telemetry) {
  const world::VehicleState& state = telemetry.state;
  wire::Telemetry sample;
  sample.uav = telemetry.uav;
  sample.position = to_float_wire(state.position);
  sample.velocity = to_float_wire(state.velocity);
  sample.heading = static_cast<float>(state.heading);
  sample.energy = static_cast<float>(state.energy);
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

namespace {

/// A PerceptionReport or a Sighting, which say the same.
template <class Look>
Look look_of(const world::Perception& perception) {
  Look look;
  look.uav = perception.uav;
  look.device = perception.device;
  look.viewpoint = to_float_wire(perception.viewpoint);
  look.view_direction = to_float_wire(perception.direction);
  look.range = static_cast<float>(perception.range);
  look.aperture = static_cast<float>(perception.aperture);
  for (const world::Detection& seen : perception.detections) {
    look.detections.push_back({seen.kind, to_float_wire(seen.position),
                               static_cast<float>(seen.spread),
                               static_cast<float>(seen.confidence)});
  }
  return look;
}

template <class Look>
world::Perception perception_of(const Look& look) {
  world::Perception perception;
  perception.uav = look.uav;
  perception.device = look.device;
  perception.viewpoint = translation::from_wire(look.viewpoint);
  perception.direction = translation::from_wire(look.view_direction);
  perception.range = look.range;
  perception.aperture = look.aperture;
  perception.at = MissionTime::nanoseconds(look.header.mission_time);
  for (const wire::Detection& seen : look.detections) {
    perception.detections.push_back(
        {seen.kind, translation::from_wire(seen.position), seen.spread, seen.confidence});
  }
  return perception;
}

}  // namespace

wire::PerceptionReport to_wire(const world::Perception& perception) {
  return look_of<wire::PerceptionReport>(perception);
}

wire::Sighting sighting_of(const world::Perception& perception) {
  return look_of<wire::Sighting>(perception);
}

world::Perception from_wire(const wire::PerceptionReport& report) { return perception_of(report); }

world::Perception from_wire(const wire::Sighting& sighting) { return perception_of(sighting); }

std::vector<double> for_journal(const world::Vector3& v) {
  return journal::rounded(std::vector<double>{v.x(), v.y(), v.z()});
}

}  // namespace skein::translation
