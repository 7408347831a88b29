// SPDX-License-Identifier: Apache-2.0
// Vehicles and worlds for the tests of the refiners.
#pragma once

#include <numbers>

#include "skein/refiners/setting.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners::testing {

/// Hovers; 10 m/s, at most 15; climbs 4 m/s, descends 3.
inline world::VehicleModel helicopter() {
  world::VehicleModel model;
  model.name = "helicopter";
  model.cruise_speed = 10;
  model.max_speed = 15;
  model.climb_rate = 4;
  model.descent_rate = 3;
  model.acceleration = 2;
  model.yaw_rate = 1;
  model.ceiling = 500;
  model.energy = {.capacity = 5e6,
                  .ground_power = 50,
                  .hover_power = 1000,
                  .cruise_power = 1200,
                  .climb_power = 500,
                  .reserve = 0.1};
  return model;
}

/// Cannot hover: 8 to 25 m/s, cruise 15; turns of 40 m; climbs 3 m/s, descends 4.
inline world::VehicleModel fixed_wing() {
  world::VehicleModel model = helicopter();
  model.name = "fixed-wing";
  model.kind = world::VehicleKind::kFixedWing;
  model.hovers = false;
  model.min_speed = 8;
  model.cruise_speed = 15;
  model.max_speed = 25;
  model.climb_rate = 3;
  model.descent_rate = 4;
  model.yaw_rate = 0;
  model.min_turn_radius = 40;
  model.orbit_radius = 60;
  return model;
}

/// Level ground at 0 over [-half, half]², no wind, free air up to `top` in voxels of 20 m.
inline world::World level_world(double half = 1000, double top = 200) {
  world::TerrainSpec spec;
  spec.west = spec.south = -half;
  spec.east = spec.north = half;
  const auto across = static_cast<std::int32_t>(2 * half / 20);
  return {.origin = {},
          .terrain = world::Terrain(spec),
          .wind = {},
          .airspace = {.origin = {-half, -half, 0},
                       .voxel = 20,
                       .size = {across, across, static_cast<std::int32_t>(top / 20)}},
          .volumes = {},
          .ground = {},
          .radio = {},
          .zones = {},
          .places = {}};
}

}  // namespace skein::refiners::testing
