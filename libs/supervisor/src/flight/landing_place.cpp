// SPDX-License-Identifier: Apache-2.0
#include "flight/landing_place.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "flight/flight_times.hpp"
#include "skein/world/crossing.hpp"
#include "skein/world/landing_ground.hpp"

namespace skein::supervisor {

namespace {

using world::Vector2;
using world::Vector3;

constexpr double kStep = 15, kFarthest = 600;  // [m]
constexpr int kDirections = 24;

/// How far from where it means to it may touch down [m].
double astray(const Knowledge& knowledge, const world::World& world) {
  const world::VehicleModel& vehicle = knowledge.vehicle;
  return arrival_distance(vehicle, world.wind) + (vehicle.hovers ? 0 : vehicle.orbit_radius);
}

/// How far beside a place it may be while it comes down there [m]. One that circles comes to above
/// the place and turns as narrowly as it can; a wind carries it on meanwhile.
double beside(const world::VehicleModel& vehicle, const world::Wind& wind) {
  if (vehicle.hovers) return 0;
  const double half_turn = std::numbers::pi * vehicle.min_turn_radius / vehicle.cruise_speed;
  const double carried = vehicle.wind_drift * (wind.speed + wind.gusts) * half_turn;
  return std::max(vehicle.orbit_radius, 2 * vehicle.min_turn_radius + carried);
}

Vector3 ground_at(const world::World& world, const Vector2& at) {
  return {at.x(), at.y(), world.terrain.elevation(at.x(), at.y())};
}

const world::Volume* closed_within(double margin, const Knowledge& knowledge,
                                   const world::World& world, world::TimeWindow when,
                                   const Vector3& at) {
  const Vector3 ground = ground_at(world, at.head<2>());
  const Vector3 above = ground + Vector3(0, 0, knowledge.altitude);
  const auto found =
      std::find_if(world.volumes.begin(), world.volumes.end(), [&](const world::Volume& volume) {
        return volume.when.overlaps(when) && crosses(volume, margin, ground, above);
      });
  return found == world.volumes.end() ? nullptr : &*found;
}

/// Whether it may wait over a place, as ways that end there must allow.
bool may_wait_over(const Knowledge& knowledge, const world::World& world, world::TimeWindow when,
                   const Vector3& at) {
  const world::VehicleModel& vehicle = knowledge.vehicle;
  const double around = std::max(vehicle.body_radius, waiting_reach(vehicle, world.wind));
  return closed_within(around, knowledge, world, when, at) == nullptr;
}

/// Of the places around `wanted` that are fit the nearest, of equally near ones that to `from`.
std::optional<Vector3> nearest(const world::World& world, const Vector3& from,
                               const Vector3& wanted,
                               const std::function<bool(const Vector3&)>& fit) {
  for (double out = kStep; out <= kFarthest; out += kStep) {
    std::optional<Vector3> best;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      const Vector3 at =
          ground_at(world, wanted.head<2>() + out * Vector2(std::cos(angle), std::sin(angle)));
      const auto far = [&](const Vector3& one) { return (one - from).head<2>().norm(); };
      if ((!best || far(at) < far(*best)) && fit(at)) best = at;
    }
    if (best) return best;
  }
  return std::nullopt;
}

}  // namespace

const world::Volume* closed_over(const Knowledge& knowledge, const world::World& world,
                                 world::TimeWindow when, const Vector3& at) {
  const double margin = knowledge.vehicle.body_radius + beside(knowledge.vehicle, world.wind);
  return closed_within(margin, knowledge, world, when, at);
}

std::optional<std::string> landing_problem(const Knowledge& knowledge, const world::World& world,
                                           world::TimeWindow when, const Vector3& at) {
  if (auto steep = world::landing_problem(world.terrain, at.head<2>(), astray(knowledge, world)))
    return steep;
  if (const auto* volume = closed_over(knowledge, world, when, at))
    return "the air over it is closed (volume '" + volume->name + "')";
  return std::nullopt;
}

std::optional<Vector3> landing_place(const Knowledge& knowledge, const world::World& world,
                                     world::TimeWindow when, const Vector3& from,
                                     const Vector3& wanted) {
  const auto fit = [&](const Vector3& at) { return !landing_problem(knowledge, world, when, at); };
  if (fit(wanted)) return wanted;
  const auto at = nearest(world, from, wanted, [&](const Vector3& one) {
    return fit(one) && may_wait_over(knowledge, world, when, one);
  });
  return at ? at : nearest(world, from, wanted, fit);  // who must land lands
}

}  // namespace skein::supervisor
