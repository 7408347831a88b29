// SPDX-License-Identifier: Apache-2.0
#include "flight/retreat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "flight/flight_times.hpp"
#include "flight/highest_between.hpp"
#include "flight/landing_place.hpp"
#include "skein/supervisor/way_home.hpp"
#include "skein/world/crossing.hpp"
#include "skein/world/way_energy.hpp"

namespace skein::supervisor {

namespace {

using world::Vector3;

/// Of a flight estimated; with 1.1 landings that are planned took up to 0.7 % more than the
/// estimate.
constexpr double kUnforeseen = 1.12;
constexpr double kUnforeseenOnGround = 1.5;  // ways over the ground are longer than straight ones
constexpr double kGathering = 60;            // [s]
constexpr double kCircles = 3;
constexpr double kMissed = 0.5;  // points of a way in circles, of which the first is at any angle
constexpr double kLeastClearance = 5;  // [m] over hills on the way
constexpr double kRounding = 1e-9;     // of sums of energies
constexpr double kClimbShare = 0.8;    // of its rates, as ways are made with

double border(const world::Polygon& corners) {
  double length = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    length += (corners[(i + 1) % corners.size()] - corners[i]).norm();
  return length;
}

}  // namespace

Whereabouts after(Whereabouts start, const std::vector<mission::ElementaryTask>& tasks) {
  for (const mission::ElementaryTask& task : tasks) {
    const bool lands = task.type == "land";
    if (!task.way.empty()) start.position = task.way.back();
    if (lands || !task.way.empty() || task.type == "takeoff") start.airborne = !lands;
  }
  return start;
}

double Retreat::of_stay(double seconds) const {
  const world::VehicleModel& vehicle = knowledge_.vehicle;
  const double speed = vehicle.hovers ? 0 : vehicle.cruise_speed;
  return seconds * world::flight_power(vehicle, speed, 0) / vehicle.energy.capacity;
}

double Retreat::flight(const std::vector<Vector3>& way) const {
  const world::VehicleModel& vehicle = knowledge_.vehicle;
  if (vehicle.energy.capacity <= 0 || vehicle.cruise_speed <= 0) return 0;
  const refiners::Flight flight = refiners::estimate_flight(way, vehicle, world_.wind);
  if (flight.duration.expected == Duration::max()) return std::numeric_limits<double>::infinity();
  const double estimate = flight.duration.expected.to_seconds();
  if (at_most_) return flight.energy + of_stay(lost_at_most(estimate));
  const double expected = flight_times(way, vehicle, world_.wind).expected;
  return flight.energy + of_stay(std::max(0.0, expected - estimate));
}

/// Beyond what a flight is estimated at: as much again, a minute, and circles.
double Retreat::lost_at_most(double seconds) const {
  const world::VehicleModel& vehicle = knowledge_.vehicle;
  const double circle = 2 * std::numbers::pi * vehicle.orbit_radius / vehicle.cruise_speed;
  return seconds + kGathering + (vehicle.hovers ? 0 : kCircles * circle);
}

double Retreat::descent(const Vector3& from) const {
  const world::VehicleModel& vehicle = knowledge_.vehicle;
  if (vehicle.energy.capacity <= 0 || vehicle.descent_rate <= 0) return 0;
  const double height = from.z() - world_.terrain.elevation(from.x(), from.y());
  return of_stay(landing_times(std::max(0.0, height), vehicle).expected);
}

/// Half the way round what is closed now or later and is nearer to the straight way than ways keep
/// away from it, or leaves one that cannot hover no room for its turns there [m].
double Retreat::detour(const Vector3& from, const Vector3& to) const {
  const world::VehicleModel& vehicle = knowledge_.vehicle;
  const double room = vehicle.hovers ? 0 : vehicle.orbit_radius + vehicle.min_turn_radius;
  const double circle = 2 * std::numbers::pi * room;
  const double margin =
      std::max(room + vehicle.body_radius, arrival_distance(vehicle, world_.wind));
  double length = 0;
  for (const world::Volume& volume : world_.volumes) {
    const bool counts = now_ < volume.when.until;
    if (counts && crosses(volume, margin, from, to))
      length += std::max(circle, border(volume.polygon) / 2);
  }
  return length;
}

/// Height that hills between make it climb beyond both ends [m].
double Retreat::climb(const Vector3& from, const Vector3& to) const {
  const double highest = highest_between(world_.terrain, from, to, world_.terrain.spec().cell);
  return std::max(0.0, highest + kLeastClearance - std::max(from.z(), to.z()));
}

/// Of one that cannot hover: until it is up or down there, in full circles where the way is too
/// short for that; from some headings it misses a point of them [s].
double Retreat::circling(const Vector3& from, const Vector3& to) const {
  const world::VehicleModel& vehicle = knowledge_.vehicle;
  if (vehicle.hovers) return 0;
  const double length = (to - from).head<2>().norm(), rise = to.z() - from.z();
  const double rate = kClimbShare * (rise > 0 ? vehicle.climb_rate : vehicle.descent_rate);
  const double needed = std::abs(rise) / std::max(rate, 1e-3) * vehicle.cruise_speed;
  const double circle = 2 * std::numbers::pi * vehicle.orbit_radius;
  const double circles = circle > 0 ? std::ceil(std::max(0.0, needed - length) / circle) : 0;
  if (circles <= 0) return 0;
  return (length + circles * circle) / vehicle.cruise_speed +
         kMissed * turning_back_seconds(vehicle, world_.wind);
}

double Retreat::energy(const Vector3& from, const Vector3& to) const {
  const world::VehicleModel& vehicle = knowledge_.vehicle;
  if (vehicle.energy.capacity <= 0 || vehicle.cruise_speed <= 0) return 0;
  const double ground = world_.terrain.elevation(to.x(), to.y());
  const Vector3 over(to.x(), to.y(), ground + std::min(knowledge_.altitude, vehicle.ceiling));
  const double around = detour(from, over) / vehicle.cruise_speed;
  const double rise = climb(from, over) / std::max(vehicle.climb_rate, 1e-3);
  const double joules = rise * world::flight_power(vehicle, 0, vehicle.climb_rate) +
                        around * world::flight_power(vehicle, vehicle.cruise_speed, 0);
  const double asked = world::energy_asked_for(vehicle, from, {over}, vehicle.cruise_speed);
  const double unforeseen = vehicle.ground ? kUnforeseenOnGround : kUnforeseen;
  const double level =
      std::max(unforeseen * std::max(flight({from, over}), of_stay(circling(from, over))),
               asked / vehicle.energy.capacity);
  return level + unforeseen * (joules / vehicle.energy.capacity + descent(over));
}

std::optional<Vector3> Retreat::instead_of_home(const Vector3& from, double left) const {
  if (home(from) <= left) return std::nullopt;
  return landing_place(knowledge_, world_, {now_}, from, from);
}

double Retreat::home_along(const std::vector<Vector3>& way) const {
  const double flown = way.size() > 1 ? kUnforeseen * flight(way) : 0;
  return flown + home(way.back());
}

double least_to_come_home(const Knowledge& knowledge, const world::World& world, MissionTime now,
                          const std::vector<Vector3>& way) {
  if (knowledge.vehicle.energy.capacity <= 0) return 0;
  return Retreat(knowledge, world, now).home_along(way) + kSpareEnergy +
         knowledge.vehicle.energy.reserve;
}

double least_to_come_home(const Knowledge& knowledge, const world::World& world, MissionTime now,
                          const Vector3& from) {
  return least_to_come_home(knowledge, world, now, std::vector{from});
}

bool must_come_home(double energy, const Knowledge& knowledge, const world::World& world,
                    MissionTime now, const std::vector<Vector3>& way) {
  const Retreat rough = Retreat(knowledge, world, now).at_most();
  const double beside = kSpareEnergy + knowledge.vehicle.energy.reserve;
  if (knowledge.vehicle.energy.capacity > 0 && energy > rough.home_along(way) + beside + kRounding)
    return false;
  return energy <= least_to_come_home(knowledge, world, now, way);
}

bool must_come_home(double energy, const Knowledge& knowledge, const world::World& world,
                    MissionTime now, const Vector3& from) {
  return must_come_home(energy, knowledge, world, now, std::vector{from});
}

bool must_land(double energy, const Knowledge& knowledge, const world::World& world,
               MissionTime now, const std::vector<Vector3>& way) {
  return must_come_home(energy + kSpareEnergy / 2, knowledge, world, now, way);
}

std::string percent(double fraction) {
  if (!std::isfinite(fraction)) return "more than all";
  std::string text = std::to_string(std::round(fraction * 1000) / 10);
  text.erase(text.find('.') + 2);
  return text + " %";
}

}  // namespace skein::supervisor
