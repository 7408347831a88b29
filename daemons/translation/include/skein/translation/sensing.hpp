// SPDX-License-Identifier: Apache-2.0
// Vehicle states, perceptions and alarms: wire to domain and back.
#pragma once

#include "skein/blackboard/wire.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::translation {

wire::Vector3 to_wire(const world::Vector3& v);
world::Vector3 from_wire(const wire::Vector3& v);
/// Rounded to single precision.
wire::FloatVector3 to_float_wire(const world::Vector3& v);
world::Vector3 from_wire(const wire::FloatVector3& v);

/// Numbers are rounded to single precision, as in looks.
wire::Telemetry to_wire(const world::Telemetry& telemetry);
/// The instant is that of the sample's header.
world::Telemetry from_wire(const wire::Telemetry& sample);

wire::PerceptionReport to_wire(const world::Perception& perception);
wire::Sighting sighting_of(const world::Perception& perception);
/// The instant is that of the sample's header.
world::Perception from_wire(const wire::PerceptionReport& report);
world::Perception from_wire(const wire::Sighting& sighting);

/// [x, y, z] as the event log has it.
std::vector<double> for_journal(const world::Vector3& v);

}  // namespace skein::translation
