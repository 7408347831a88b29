// SPDX-License-Identifier: Apache-2.0
// Where a device on board looks.
#pragma once

#include <optional>

#include "skein/world/sensor_model.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::elementary {

/// The cone the sensor looks through: at the target if it is gimballed and has one (turned aside by
/// `pointing_error` [rad]), else ahead of the vehicle at its pitch.
world::View view_of(const world::SensorModel& sensor, const world::VehicleState& state,
                    const std::optional<world::Vector3>& target, double pointing_error);

}  // namespace skein::elementary
