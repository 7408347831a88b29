// SPDX-License-Identifier: Apache-2.0
// A vehicle that maps.
#pragma once

#include <cmath>

#include "skein/world/vehicle_model.hpp"

namespace skein::decision_node::testing {

/// Gives the vehicle what it takes to map, with a camera "mapping" that looks down, 30 m to each
/// side from 60 m up.
inline void make_map(world::VehicleModel& vehicle) {
  vehicle.max_speed = 14;
  vehicle.climb_rate = vehicle.descent_rate = 3;
  vehicle.acceleration = 2;
  vehicle.yaw_rate = 0.8;
  vehicle.ceiling = 200;
  vehicle.energy = {6.5e6, 100, 1700, 1500, 400, 0.1};
  world::SensorModel camera;
  camera.device = "mapping";
  camera.aperture = std::atan(0.5);
  camera.boresight_pitch = -1.5708;
  camera.range = 200;
  camera.period = Duration::seconds(1);
  vehicle.sensors.push_back(camera);
}

}  // namespace skein::decision_node::testing
