// SPDX-License-Identifier: Apache-2.0
// How vehicles approach way-points and come to rest.
#pragma once

#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"

namespace skein::world {

/// Gain of the position controller: commanded speed per metre of position error [1/s].
constexpr double kPositionGain = 0.5;

/// Distance at which a way-point counts as reached [m]: three standard deviations of tracking and a
/// metre; for hovering vehicles also the offset at which they come to rest in a wind that they do
/// not fully compensate.
double reaching_distance(const VehicleModel& model, const Wind& wind);

/// Stopping distance from this speed [m/s] at full deceleration [m].
double braking_distance(const VehicleModel& model, double speed);

}  // namespace skein::world
