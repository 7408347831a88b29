// SPDX-License-Identifier: Apache-2.0
// Vehicle states, perceptions and alarms: wire to domain and back.
#pragma once

#include "skein/blackboard/wire.hpp"
#include "skein/world/parameters.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::translation {

wire::Vector3 to_wire(const world::Vector3& v);
world::Vector3 from_wire(const wire::Vector3& v);

wire::Telemetry to_wire(const std::string& uav, const world::VehicleState& state);
world::VehicleState from_wire(const wire::Telemetry& telemetry);

wire::PerceptionReport to_wire(const world::Perception& perception);
/// The instant is that of the sample's header.
world::Perception from_wire(const wire::PerceptionReport& report);

std::vector<wire::Parameter> to_wire(const world::Parameters& parameters);
world::Parameters from_wire(const std::vector<wire::Parameter>& parameters);

/// [x, y, z] as the event log has it.
std::vector<double> for_journal(const world::Vector3& v);

}  // namespace skein::translation
