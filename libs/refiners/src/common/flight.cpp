// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/straight_flight.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

constexpr double kNever = std::numeric_limits<double>::infinity();
/// More than that is for ever: 300 years, which a Duration in nanoseconds can just not hold.
constexpr double kForever = 9e9;

Duration duration_of(double seconds) {
  return seconds < kForever ? Duration::seconds(seconds) : Duration::max();
}

/// Speed over the ground along a track, held against a wind; 0 when it cannot be.
double ground_speed(double airspeed, const Vector2& wind, const Vector2& track) {
  const double along = wind.dot(track);
  const double across2 = std::max(0.0, wind.squaredNorm() - along * along);
  if (across2 >= airspeed * airspeed) return 0;
  return std::max(0.0, along + std::sqrt(airspeed * airspeed - across2));
}

double time_over(double length, double speed) {
  if (length == 0) return 0;
  return speed > 0 ? length / speed : kNever;
}

/// What one leg asks for, whatever the wind.
struct Leg {
  double level;     ///< [m]
  double vertical;  ///< least time its climb or descent takes [s]
  double rise;      ///< [m]
  Vector2 track;    ///< unit length; zero when it is vertical
};

Leg leg_of(const Vector3& from, const Vector3& to, const world::VehicleModel& vehicle) {
  const Vector3 step = to - from;
  const double level = step.head<2>().norm();
  const double rate = step.z() > 0 ? vehicle.climb_rate : vehicle.descent_rate;
  const Vector2 track = level > 0 ? Vector2(step.head<2>() / level) : Vector2(Vector2::Zero());
  return {level, time_over(std::abs(step.z()), rate), step.z(), track};
}

/// Energy of a leg that takes `seconds` [J]. What time a climb takes longer than the level part, a
/// vehicle that hovers spends slower; one that cannot flies on.
double energy_of(const Leg& leg, double seconds, double level_seconds, double speed,
                 const world::VehicleModel& vehicle) {
  const double slow = vehicle.hovers ? seconds - level_seconds : 0;
  double energy = (seconds - slow) * world::flight_power(vehicle, speed, 0) +
                  slow * world::flight_power(vehicle, 0, 0);
  if (leg.rise > 0) energy += leg.vertical * vehicle.energy.climb_power;
  return energy;
}

}  // namespace

Flight estimate_flight(const Way& way, const world::VehicleModel& vehicle, const world::Wind& wind,
                       double speed) {
  const double airspeed = speed > 0 ? speed : vehicle.cruise_speed;
  const Vector2 drift = vehicle.wind_drift * world::mean_velocity(wind).head<2>();
  const double strongest = vehicle.wind_drift * (wind.speed + wind.gusts);
  double least = 0, expected = 0, most = 0, energy = 0;
  Flight flight;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Leg leg = leg_of(way[i - 1], way[i], vehicle);
    const double level = time_over(leg.level, ground_speed(airspeed, drift, leg.track));
    const double seconds = std::max(level, leg.vertical);
    least += std::max(time_over(leg.level, vehicle.max_speed + strongest), leg.vertical);
    expected += seconds;
    most += std::max(time_over(leg.level, airspeed - strongest), leg.vertical);
    energy += energy_of(leg, seconds, level, airspeed, vehicle);
    flight.length += (way[i] - way[i - 1]).norm();
  }
  flight.duration = {duration_of(least), duration_of(expected), duration_of(most)};
  flight.energy = vehicle.energy.capacity > 0 ? energy / vehicle.energy.capacity : kNever;
  return flight;
}

StraightFlight::StraightFlight(const world::VehicleModel& vehicle, const world::Wind& wind,
                               double speed)
    : vehicle_(&vehicle),
      airspeed_(speed > 0 ? speed : vehicle.cruise_speed),
      drift_(vehicle.wind_drift * world::mean_velocity(wind).head<2>()) {}

double StraightFlight::seconds(const Vector3& from, const Vector3& to) const {
  double whole = 0;
  if (drift_.isZero(0)) {
    const Vector3 step = to - from;
    const double rate = step.z() > 0 ? vehicle_->climb_rate : vehicle_->descent_rate;
    whole =
        std::max(time_over(step.head<2>().norm(), airspeed_), time_over(std::abs(step.z()), rate));
  } else {
    const Leg leg = leg_of(from, to, *vehicle_);
    const double speed = ground_speed(airspeed_, drift_, leg.track);
    whole = std::max(time_over(leg.level, speed), leg.vertical);
  }
  // As a Duration rounds it.
  return whole < kForever ? static_cast<double>(nearest_whole(whole * 1e9)) * 1e-9 : kNever;
}

double length_of(const Way& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

}  // namespace skein::refiners
