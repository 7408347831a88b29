// SPDX-License-Identifier: Apache-2.0
// How vehicles that steer at way-points come to them, and to rest.
#pragma once

#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"

namespace skein::world {

/// Speed asked per metre of error by one that steers at a place [1/s].
constexpr double kPositionGain = 0.5;

/// So near to a way-point it counts as reached [m]: three deviations of its tracking and a metre;
/// what steers at a place in a wind that it does not make up for comes to rest beside it.
double reaching_distance(const VehicleModel& model, const Wind& wind);

/// What it still flies from that speed [m/s] with all of its acceleration against it [m].
double braking_distance(const VehicleModel& model, double speed);

}  // namespace skein::world
