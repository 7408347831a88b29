// SPDX-License-Identifier: Apache-2.0
// Random queries for view points, and the exhaustive search that they are compared with.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>

#include "skein/foundation/random.hpp"
#include "skein/refiners/viewpoint.hpp"

namespace skein::refiners {

struct ViewpointCase {
  world::World world;
  ViewpointQuery query;
};

inline world::TerrainSpec random_hills(Random& random) {
  world::TerrainSpec spec;
  spec.east = spec.north = 1200;
  spec.cell = 20;
  const auto hills = 4 + random.below(20);
  for (std::uint64_t i = 0; i < hills; ++i)
    spec.hills.push_back({{random.uniform(0, 1200), random.uniform(0, 1200)},
                          random.uniform(-30, 120),
                          random.uniform(60, 300)});
  return spec;
}

/// Real ground, read as metric cells of `cell` metres; nothing when the file is not there.
inline std::optional<world::TerrainSpec> jacksboro(double cell) {
  std::ifstream in(SKEIN_SOURCE_DIR "/../shared/data/geometry/jacksboro.asc");
  std::string word;
  std::size_t columns = 0, rows = 0;
  if (!(in >> word >> columns >> word >> rows)) return std::nullopt;
  for (int i = 0; i < 8; ++i) in >> word;
  world::TerrainSpec spec;
  spec.cell = cell;
  spec.east = cell * static_cast<double>(columns - 1);
  spec.north = cell * static_cast<double>(rows - 1);
  spec.elevations.resize(columns * rows);
  for (std::size_t row = rows; row-- > 0;)
    for (std::size_t column = 0; column < columns; ++column)
      in >> spec.elevations[row * columns + column];
  return in ? std::optional(spec) : std::nullopt;
}

inline world::VehicleModel a_helicopter() {
  world::VehicleModel vehicle;
  vehicle.name = "bee";
  vehicle.cruise_speed = 8;
  vehicle.max_speed = 14;
  vehicle.climb_rate = 3;
  vehicle.descent_rate = 2;
  vehicle.acceleration = 2;
  vehicle.yaw_rate = 0.8;
  vehicle.ceiling = 150;
  vehicle.energy.capacity = 6e6;
  vehicle.energy.hover_power = 1700;
  vehicle.energy.cruise_power = 1500;
  return vehicle;
}

inline world::SensorModel a_camera() {
  world::SensorModel camera;
  camera.device = "visible";
  camera.aperture = 0.35;
  camera.boresight_pitch = -0.6;
  camera.gimballed = true;
  camera.range = 250;
  camera.quality = {40, 0.2, 1};
  camera.responses["fire"] = {0.9, 0.9, "fire"};
  return camera;
}

inline world::SensorModel random_sensor(Random& random, double scale) {
  world::SensorModel camera = a_camera();
  camera.range = scale * random.uniform(100, 400);
  camera.quality = {camera.range * random.uniform(0, 0.5), random.uniform(0, 0.8),
                    random.chance(0.2) ? 0 : random.uniform(0.3, 2)};
  if (random.chance(0.1)) camera.quality = {};
  camera.cost = random.uniform(0, 0.1);
  if (random.chance(0.7)) return camera;
  camera.gimballed = false;
  camera.aperture = random.uniform(0.2, 0.8);
  camera.boresight_pitch = random.chance(0.5) ? -std::numbers::pi / 2 : random.uniform(-1.2, -0.1);
  return camera;
}

inline world::Volume random_volume(Random& random, const world::Vector3& near, double scale) {
  const world::Vector2 at(near.x() + scale * random.uniform(-200, 200),
                          near.y() + scale * random.uniform(-200, 200));
  world::Volume volume;
  volume.name = "zone";
  const auto corners = 3 + random.below(4);
  const double radius = scale * random.uniform(20, 120);
  for (std::uint64_t i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / double(corners);
    volume.polygon.push_back(at + radius * world::Vector2(std::cos(turn), std::sin(turn)));
  }
  if (random.chance(0.5)) volume.floor = near.z() + scale * random.uniform(0, 80);
  if (random.chance(0.5)) volume.ceiling = near.z() + scale * random.uniform(80, 200);
  return volume;
}

/// `scale` 1: a terrain of some hundred metres; larger for a larger one.
inline ViewpointCase random_case(std::uint64_t seed, const world::TerrainSpec& ground,
                                 double scale) {
  Random random(seed, "viewpoint");
  const world::Terrain terrain(ground);
  ViewpointCase made{{{}, terrain, {}, {}, {}, {}, {}, {}, {}}, {}};
  made.world.airspace = {
      {0, 0, -100},
      10,
      {static_cast<std::int32_t>(ground.east / 10), static_cast<std::int32_t>(ground.north / 10),
       static_cast<std::int32_t>(terrain.highest() / 10) + 40}};
  ViewpointQuery& query = made.query;
  const double x = ground.east * random.uniform(0.1, 0.9),
               y = ground.north * random.uniform(0.1, 0.9);
  query.target = {x, y, terrain.elevation(x, y) + (random.chance(0.3) ? random.uniform(0, 5) : 0)};
  query.vehicle = a_helicopter();
  query.vehicle.ceiling = scale * random.uniform(80, 300);
  query.vehicle.sensors = {random_sensor(random, scale)};
  query.device = "visible";
  query.nearest = scale * random.uniform(0, 60);
  query.clearance = scale * random.uniform(5, 40);
  if (random.chance(0.7)) {
    query.from = query.target +
                 scale * world::Vector3(random.uniform(-400, 400), random.uniform(-400, 400), 60);
    query.cost_of_way = random.chance(0.7) ? random.uniform(0, 0.001) / scale : 0;
  }
  for (auto volumes = random.below(4); volumes-- > 0;)
    made.world.volumes.push_back(random_volume(random, query.target, scale));
  if (random.chance(0.3)) {
    const double heading = random.uniform(-3.14, 3.14), offset = scale * random.uniform(-50, 100);
    const world::Vector3 side = world::direction_of(heading, 0), target = query.target;
    query.constraints.push_back({"beside", [=](const world::Vector3& place) {
                                   return (place - target).dot(side) <= offset;
                                 }});
  }
  return made;
}

/// Independent of the service: written from the header, place by place.
inline bool will_do(const ViewpointCase& c, const world::Vector3& place, bool with_sight = true) {
  const world::SensorModel& sensor = c.query.vehicle.sensors[0];
  const world::AirspaceGrid& air = c.world.airspace;
  for (int axis = 0; axis < 3; ++axis)
    if (place[axis] < air.origin[axis] ||
        place[axis] > air.origin[axis] + air.voxel * air.size[static_cast<std::size_t>(axis)])
      return false;
  const double height = place.z() - c.world.terrain.elevation(place.x(), place.y());
  if (height < c.query.clearance || height > c.query.vehicle.ceiling) return false;
  const world::Vector3 offset = c.query.target - place;
  const double distance = offset.norm();
  const double farthest =
      c.query.farthest > 0 ? std::min(c.query.farthest, sensor.range) : sensor.range;
  if (distance < c.query.nearest || distance > farthest) return false;
  const double pitch = std::asin(std::clamp(offset.z() / distance, -1.0, 1.0));
  if (!sensor.gimballed && std::abs(pitch - sensor.boresight_pitch) > sensor.aperture) return false;
  for (const world::Volume& volume : c.world.volumes)
    if (volume.when.until > c.query.at && place.z() >= volume.floor &&
        place.z() <= volume.ceiling && world::contains(volume.polygon, place.head<2>()))
      return false;
  for (const PlaceConstraint& constraint : c.query.constraints)
    if (!constraint.holds(place)) return false;
  if (!with_sight) return true;
  world::Vector3 seen = c.query.target;
  seen.z() = std::max(seen.z(), c.world.terrain.elevation(seen.x(), seen.y()) + 0.01);
  return c.world.terrain.line_of_sight(place, seen);
}

/// Of the ground, by differences over half a cell on either side.
inline world::Vector3 ground_normal(const world::Terrain& terrain, const world::Vector3& at) {
  const double h = terrain.spec().cell / 2;
  const auto z = [&](double dx, double dy) { return terrain.elevation(at.x() + dx, at.y() + dy); };
  const world::Vector3 east(2 * h, 0, z(h, 0) - z(-h, 0)), north(0, 2 * h, z(0, h) - z(0, -h));
  return world::Vector3(east.y() * north.z() - east.z() * north.y(),
                        east.z() * north.x() - east.x() * north.z(),
                        east.x() * north.y() - east.y() * north.x())
      .normalized();
}

inline double utility_of(const ViewpointCase& c, const world::Vector3& place,
                         const world::Vector3& normal) {
  const world::SensorModel& sensor = c.query.vehicle.sensors[0];
  const double quality = world::perceived_quality(sensor, place, c.query.target, normal);
  if (!(quality > 0)) return -1e9;
  const double way = c.query.from ? (place - *c.query.from).norm() : 0;
  return quality - sensor.cost - c.query.cost_of_way * way;
}

struct Exhaustive {
  std::optional<double> utility;   ///< of the best
  std::uint64_t sight_checks = 0;  ///< one for each place where all else holds
};

/// Every place of a lattice four times finer along each axis than the first one of the service (48
/// azimuths × 20 elevations × 8 distances), turned by some part of a step so that they do not
/// coincide. `lazy`: sight that cannot matter is counted but not traced.
inline Exhaustive search_all(const ViewpointCase& c, double phase, bool lazy) {
  constexpr int turns = 4 * 48, tilts = 4 * 20, ranges = 4 * 8;
  const world::SensorModel& sensor = c.query.vehicle.sensors[0];
  const world::Vector3 normal = ground_normal(c.world.terrain, c.query.target);
  Exhaustive best;
  for (int turn = 0; turn < turns; ++turn)
    for (int tilt = 0; tilt < tilts; ++tilt)
      for (int range = 0; range < ranges; ++range) {
        const double azimuth = 2 * std::numbers::pi * (turn + phase) / turns;
        const double elevation = std::numbers::pi * ((tilt + 0.5) / tilts - 0.5);
        const double distance =
            c.query.nearest + (sensor.range - c.query.nearest) * range / (ranges - 1);
        const world::Vector3 place =
            c.query.target + distance * world::direction_of(azimuth, elevation);
        const double utility = utility_of(c, place, normal);
        if (utility < -1e8 || !will_do(c, place, false)) continue;
        ++best.sight_checks;
        if (lazy && best.utility && utility <= *best.utility) continue;
        if (!will_do(c, place)) continue;
        if (!best.utility || utility > *best.utility) best.utility = utility;
      }
  return best;
}

/// How much of what the exhaustive search found was found; 1 when there was nothing to find.
inline double share_found(const Exhaustive& all, const std::optional<double>& found) {
  if (!all.utility) return 1;
  if (!found) return 0;
  if (*all.utility > 0.01) return *found / *all.utility;
  return 1 + (*found - *all.utility);
}

}  // namespace skein::refiners
