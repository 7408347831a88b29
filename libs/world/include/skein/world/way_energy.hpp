// SPDX-License-Identifier: Apache-2.0
// What a vehicle wants to hold before it flies a way: the one rule of vehicles and of who plans.
#pragma once

#include <vector>

#include "skein/world/geometry.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::world {

/// Energy [J] that a vehicle asks for before it flies from point to point [m] ENU at a speed
/// through the air [m/s], > 0, in still air; one that cannot hover asks for its turns on top. It
/// refuses a way for which it does not hold as much above its reserve. Cost: O(points).
double energy_asked_for(const VehicleModel& model, Vector3 from, const std::vector<Vector3>& way,
                        double speed);

}  // namespace skein::world
