// SPDX-License-Identifier: Apache-2.0
// Worlds and queries for the tests of path.
#pragma once

#include "skein/refiners/path.hpp"
#include "skein/world/world.hpp"

namespace skein::refiners::testing {

inline world::VehicleModel helicopter() {
  world::VehicleModel vehicle;
  vehicle.name = "helicopter";
  vehicle.cruise_speed = 10;
  vehicle.max_speed = 15;
  vehicle.climb_rate = 3;
  vehicle.descent_rate = 3;
  vehicle.acceleration = 2;
  vehicle.yaw_rate = 1;
  vehicle.ceiling = 500;
  vehicle.body_radius = 1;
  vehicle.energy.capacity = 1e7;
  vehicle.energy.hover_power = 1000;
  vehicle.energy.cruise_power = 1200;
  vehicle.energy.climb_power = 500;
  return vehicle;
}

inline world::VehicleModel plane() {
  world::VehicleModel vehicle = helicopter();
  vehicle.name = "plane";
  vehicle.kind = world::VehicleKind::kFixedWing;
  vehicle.hovers = false;
  vehicle.min_speed = 8;
  vehicle.min_turn_radius = 25;
  vehicle.orbit_radius = 40;
  return vehicle;
}

/// 600 × 600 m of ground with some hills, under 200 m of air in voxels of 10 m.
inline world::World hilly_world(std::vector<world::HillSpec> hills) {
  world::TerrainSpec ground;
  ground.east = ground.north = 600;
  ground.cell = 20;
  ground.hills = std::move(hills);
  world::AirspaceGrid grid;
  grid.size = {60, 60, 20};
  world::World world{{}, world::Terrain(ground), {}, grid, {}, {}, {}, {}, {}};
  world.radio.range = 400;
  return world;
}
inline world::World flat_world() { return hilly_world({}); }

inline world::Polygon rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}
inline world::Volume wall(const std::string& name, double west, double south, double east,
                          double north) {
  world::Volume volume;
  volume.name = name;
  volume.polygon = rectangle(west, south, east, north);
  return volume;
}

inline PathQuery query(const world::Vector3& from, const world::Vector3& to) {
  PathQuery query;
  query.vehicle = helicopter();
  query.from = from;
  query.to = to;
  return query;
}

}  // namespace skein::refiners::testing
