// SPDX-License-Identifier: Apache-2.0
// Worlds, vehicles and random scenes that the tests share.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/path.hpp"
#include "skein/world/world.hpp"

namespace skein::sampling {

inline world::VehicleModel a_helicopter() {
  world::VehicleModel vehicle;
  vehicle.name = "marvin";
  vehicle.hovers = true;
  vehicle.cruise_speed = 8;
  vehicle.max_speed = 12;
  vehicle.climb_rate = 2.5;
  vehicle.descent_rate = 1.5;
  vehicle.acceleration = 1.5;
  vehicle.yaw_rate = 0.6;
  vehicle.ceiling = 500;
  vehicle.energy.capacity = 7e6;
  vehicle.energy.hover_power = 1900;
  vehicle.energy.cruise_power = 1700;
  return vehicle;
}

inline world::VehicleModel a_blimp() {
  world::VehicleModel vehicle = a_helicopter();
  vehicle.name = "karma";
  vehicle.kind = world::VehicleKind::kBlimp;
  vehicle.hovers = false;
  vehicle.min_speed = 2;
  vehicle.min_turn_radius = 25;
  vehicle.orbit_radius = 40;
  vehicle.climb_rate = 1.5;
  vehicle.descent_rate = 1.2;
  vehicle.energy.hover_power = 250;
  vehicle.energy.cruise_power = 600;
  return vehicle;
}

/// A square kilometre of level ground at 0, and 200 m of air.
inline world::World a_plain() {
  world::TerrainSpec terrain;
  terrain.east = terrain.north = 1000;
  world::World world{{}, world::Terrain(terrain), {}, {}, {}, {}, {}, {}, {}};
  world.airspace = {{0, 0, 0}, 10, {100, 100, 20}};
  world.radio.range = 1e5;
  return world;
}

/// The same with hills; the tallest reach through most of the air.
inline world::World hills(Random& random, int count = 12) {
  world::TerrainSpec terrain;
  terrain.east = terrain.north = 1000;
  for (int i = 0; i < count; ++i)
    terrain.hills.push_back({{random.uniform(0, 1000), random.uniform(0, 1000)},
                             random.uniform(30, 160),
                             random.uniform(80, 250)});
  world::World world = a_plain();
  world.terrain = world::Terrain(terrain);
  return world;
}

inline world::Volume a_box(std::string name, const world::Vector2& south_west,
                           const world::Vector2& north_east, double floor, double ceiling) {
  return {
      std::move(name),
      {south_west, {north_east.x(), south_west.y()}, north_east, {south_west.x(), north_east.y()}},
      floor,
      ceiling,
      {}};
}

/// A star-shaped, as a rule concave, volume about a point.
inline world::Volume a_star(Random& random, const std::string& name) {
  const double x = random.uniform(100, 900), y = random.uniform(100, 900);
  world::Volume volume;
  volume.name = name;
  const std::uint64_t corners = 5 + random.below(6);
  for (std::uint64_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = random.uniform(15, 90);
    volume.polygon.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  if (random.chance(0.5)) std::reverse(volume.polygon.begin(), volume.polygon.end());
  volume.floor =
      random.chance(0.3) ? -std::numeric_limits<double>::infinity() : random.uniform(0, 100);
  volume.ceiling = random.chance(0.3) ? std::numeric_limits<double>::infinity()
                                      : std::max(0.0, volume.floor) + random.uniform(20, 100);
  return volume;
}

/// From a point to a prism, by its edges: 0 inside. Nothing of the library is used but `contains`.
inline double distance_to(const world::Volume& volume, const world::Vector3& point) {
  double level = std::numeric_limits<double>::infinity();
  const world::Vector2 at = point.head<2>();
  if (world::contains(volume.polygon, at)) {
    level = 0;
  } else {
    for (std::size_t i = 0; i < volume.polygon.size(); ++i) {
      const world::Vector2 a = volume.polygon[i];
      const world::Vector2 edge = volume.polygon[(i + 1) % volume.polygon.size()] - a;
      const double t = std::clamp((at - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      level = std::min(level, (a + t * edge - at).norm());
    }
  }
  const double above = std::max({0.0, volume.floor - point.z(), point.z() - volume.ceiling});
  return std::hypot(level, above);
}

/// Points along a way, at most `spacing` apart.
inline std::vector<world::Vector3> points_along(const refiners::Way& way, double spacing) {
  std::vector<world::Vector3> points;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const int steps = 1 + static_cast<int>((way[i] - way[i - 1]).norm() / spacing);
    for (int k = 0; k <= steps; ++k)
      points.push_back(way[i - 1] + (way[i] - way[i - 1]) * k / steps);
  }
  return points;
}

}  // namespace skein::sampling
