// SPDX-License-Identifier: Apache-2.0
// Energy required before flying a way: one rule for vehicles and planners.
#pragma once

#include <vector>

#include "skein/world/geometry.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::world {

/// Energy [J] required to fly from `from` along `way` [m, ENU] at airspeed `speed` [m/s], > 0, in
/// still air; for vehicles that cannot hover, turns are added. A vehicle refuses a way for which it
/// has less than that above its reserve. Cost: O(points).
double energy_asked_for(const VehicleModel& model, Vector3 from, const std::vector<Vector3>& way,
                        double speed);

}  // namespace skein::world
