// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/own_ways.hpp"

#include <algorithm>
#include <limits>

#include "flight/flight_times.hpp"
#include "flight/highest_between.hpp"
#include "flight/landing_place.hpp"
#include "refinery/refinery.hpp"
#include "safety/warning.hpp"
#include "skein/world/crossing.hpp"
#include "skein/world/landing_ground.hpp"
#include "skein/world/segment.hpp"

namespace skein::supervisor {

using world::Vector3;

namespace {

constexpr std::uint64_t kSeed = 1;
constexpr double kOverGround = 2;  // [m] a straight way is clear of the ground,
constexpr double kOverTops = 20;   // [m] and one straight up, over, and down of what is in its way

bool closes_around(const world::Volume& volume, const world::VehicleModel& vehicle, MissionTime now,
                   const Vector3& at) {
  return volume.when.overlaps({now, now + kWarning}) &&
         crosses(volume, vehicle.body_radius + stay_radius(vehicle), at, at);
}

Duration time_for(const std::vector<Vector3>& way, const world::VehicleModel& vehicle) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return Duration::seconds(length / vehicle.cruise_speed) + kWarning;
}

/// Up where it is, over all ground in between, and down, as one that hovers can always try.
std::vector<Vector3> over_the_tops(const world::Terrain& terrain, const Vector3& from,
                                   const Vector3& to) {
  const double ground = highest_between(terrain, from, to, terrain.spec().cell / 2);
  const double top = std::max({from.z(), to.z(), ground + kOverTops});
  return {from, {from.x(), from.y(), top}, {to.x(), to.y(), top}, to};
}

}  // namespace

std::optional<WayOut> way_out(const std::shared_ptr<const Knowledge>& knowledge,
                              const std::shared_ptr<const world::World>& world, MissionTime now,
                              const Vector3& at) {
  const auto around =
      std::find_if(world->volumes.begin(), world->volumes.end(), [&](const world::Volume& volume) {
        return closes_around(volume, knowledge->vehicle, now, at);
      });
  if (around == world->volumes.end()) return std::nullopt;
  Refinery refinery(Gazetteer(knowledge, world), now, kSeed);
  const auto out = refinery.ways.way_out(at);
  if (!out) return std::nullopt;
  return WayOut{around->name, out->way.back()};
}

std::vector<std::string> closed_around(const Knowledge& knowledge, const world::World& world,
                                       MissionTime now, const Vector3& at) {
  std::vector<std::string> names;
  for (const world::Volume& volume : world.volumes)
    if (closes_around(volume, knowledge.vehicle, now, at)) names.push_back(volume.name);
  return names;
}

std::vector<Vector3> own_way(const std::shared_ptr<const Knowledge>& knowledge,
                             const std::shared_ptr<const world::World>& world, MissionTime now,
                             const Vector3& from, const Vector3& to) {
  const bool straight = world->volumes.empty() && !knowledge->vehicle.ground;
  if (straight && !world->terrain.first_hit(from, to, kOverGround)) return {from, to};
  Refinery refinery(Gazetteer(knowledge, world), now, kSeed);
  const auto way = refinery.ways.path(from, to);
  if (way && way->way.size() > 1) return way->way;
  const bool meets = world->terrain.first_hit(from, to, kOverGround).has_value();
  return meets && knowledge->vehicle.hovers ? over_the_tops(world->terrain, from, to)
                                            : std::vector<Vector3>{from, to};
}

Vector3 over_landing_place(const Knowledge& knowledge, const world::World& world, MissionTime now,
                           const Vector3& from, const Vector3& home) {
  const auto ground = [&](const Vector3& at) { return world.terrain.elevation(at.x(), at.y()); };
  const double astray = arrival_distance(knowledge.vehicle, world.wind);
  const world::TimeWindow when{now, now + time_for({from, home}, knowledge.vehicle)};
  const bool steep = world::landing_problem(world.terrain, home.head<2>(), astray).has_value();
  if (!steep && closed_over(knowledge, world, when, home) == nullptr) return home;
  const auto place = landing_place(knowledge, world, when, from, home);
  if (!place) return home;
  return {place->x(), place->y(), ground(*place) + home.z() - ground(home)};
}

namespace {

// From where it is on.
std::vector<Vector3> rest_of(const std::vector<Vector3>& way, const Vector3& at) {
  std::size_t next = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double away = world::to_segment(at, way[i - 1], way[i]);
    if (away >= nearest) continue;
    nearest = away;
    next = i;
  }
  std::vector<Vector3> rest{at};
  rest.insert(rest.end(), way.begin() + static_cast<std::ptrdiff_t>(next), way.end());
  return rest;
}

}  // namespace

std::optional<std::string> closed_ahead(const Knowledge& knowledge, const world::World& world,
                                        MissionTime now, const Vector3& at,
                                        const std::vector<Vector3>& way) {
  const world::VehicleModel& vehicle = knowledge.vehicle;
  const std::vector<Vector3> rest = rest_of(way, at);
  const MissionTime there = now + time_for(rest, vehicle);
  for (const world::Volume& volume : world.volumes) {
    const bool ahead =
        !crosses(volume, vehicle.body_radius, at, at) && crosses(volume, vehicle.body_radius, rest);
    if (ahead && volume.when.overlaps({now, there})) return volume.name;
  }
  return std::nullopt;
}

}  // namespace skein::supervisor
