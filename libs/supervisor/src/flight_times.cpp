// SPDX-License-Identifier: Apache-2.0
#include "flight_times.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skein::supervisor {

namespace {

using refiners::Way;
using world::Vector3;
using world::VehicleModel;
using world::Wind;

// Of the vehicle's time to gather its speed, v / a (docs/comets-domain.md has the derivation):
constexpr double kGathering = 0.5;  // starting from rest
constexpr double kBraking = 0.75;   // braking to rest with half the acceleration, and settling
constexpr double kCorner = 1.5;     // stopping and starting again where the way turns back
constexpr double kSettling = 4;     // of a climb, at its end
constexpr double kFlare = 6;        // of a descent, near the ground
constexpr double kSlowVertical = 1.5;
constexpr double kCorrections = 6;  // of a pilot, before it is content
constexpr double kCircles = 5;      // of a vehicle that cannot hover, at most; half of one expected
constexpr double kMargin = 3;       // most that is lost, in units of what is expected
// How far back along a way the shortest way through its tolerances is looked for.
constexpr std::size_t kWindow = 48;

// Sums that are whole but for rounding stay what they are.
constexpr double kRounding = 1e-6;

double tenths_down(double s) { return std::max(0.0, std::floor(s * 10 + kRounding) / 10); }
double tenths_up(double s) { return std::max(0.0, std::ceil(s * 10 - kRounding) / 10); }

Times rounded(double least, double expected, double most) {
  Times times{tenths_down(least), expected, tenths_up(most)};
  times.expected = std::clamp(times.expected, times.least, std::max(times.least, times.most));
  return times;
}

double greatest_drift(const VehicleModel& vehicle, const Wind& wind) {
  return vehicle.wind_drift * (wind.speed + 3 * wind.gusts);
}

/// Least length of a way that passes each point within `distance` (through some of them only, as
/// far as that is a bound).
double least_length(const Way& way, double distance) {
  std::vector<double> length(way.size(), 0);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const std::size_t first = i > kWindow ? i - kWindow : 0;
    length[i] = length[i - 1];
    for (std::size_t k = first; k < i; ++k) {
      // It begins at the first point itself.
      const double slack = (k == 0 ? 1 : 2) * distance;
      length[i] = std::max(length[i], length[k] + (way[i] - way[k]).head<2>().norm() - slack);
    }
  }
  return length.empty() ? 0 : length.back();
}

/// Share of its speed that a vehicle loses at a corner: 0 straight on, 1 turning back.
double sharpness(const Way& way, std::size_t at) {
  const Vector3 in = way[at] - way[at - 1], out = way[at + 1] - way[at];
  const double lengths = in.norm() * out.norm();
  return lengths > 0 ? (1 - in.dot(out) / lengths) / 2 : 0;
}

double leg_seconds(const Vector3& from, const Vector3& to, const VehicleModel& vehicle,
                   const Wind& wind) {
  return refiners::estimate_flight({from, to}, vehicle, wind).duration.expected.to_seconds();
}

double gathering_seconds(const VehicleModel& vehicle) {
  return vehicle.cruise_speed / vehicle.acceleration;
}

double pilot_seconds(const VehicleModel& vehicle) {
  if (!vehicle.pilot) return 0;
  return longest_reaction(vehicle) + kCorrections * vehicle.pilot->attention_period.to_seconds();
}

double circle_seconds(const VehicleModel& vehicle) {
  if (vehicle.hovers) return 0;
  return 2 * std::numbers::pi * vehicle.min_turn_radius / vehicle.cruise_speed;
}

/// Gathering speed, braking, turning: what the estimate of the refiners leaves out. A vehicle that
/// cannot hover does none of it: it goes on flying, and turns round where it must.
double lost_seconds(const Way& way, const VehicleModel& vehicle) {
  if (!vehicle.hovers) return circle_seconds(vehicle) / 2;
  double share = way.size() < 2 ? kBraking : kGathering + kBraking;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) share += kCorner * sharpness(way, i);
  return share * gathering_seconds(vehicle);
}

}  // namespace

double arrival_distance(const VehicleModel& vehicle, const Wind& wind) {
  return 4 * world::tracking_spread(vehicle) + 2 * greatest_drift(vehicle, wind);
}

double stay_radius(const VehicleModel& vehicle) {
  return 3 * world::tracking_spread(vehicle) + (vehicle.hovers ? 0 : vehicle.orbit_radius);
}

double longest_reaction(const VehicleModel& vehicle) {
  if (!vehicle.pilot) return 0;
  return (vehicle.pilot->reaction + vehicle.pilot->reaction_spread).to_seconds() +
         2 * vehicle.pilot->reaction_spread.to_seconds();
}

Times flight_times(const Way& way, const VehicleModel& vehicle, const Wind& wind) {
  const refiners::Flight flight = refiners::estimate_flight(way, vehicle, wind);
  const double near = arrival_distance(vehicle, wind);
  const double fastest = vehicle.cruise_speed + greatest_drift(vehicle, wind);
  const double rise = way.empty() ? 0 : way.back().z() - way.front().z();
  const double vertical =
      (std::abs(rise) - near) / (rise > 0 ? vehicle.climb_rate : vehicle.descent_rate);
  const double least = std::max(least_length(way, near) / fastest, vertical);
  const double lost = lost_seconds(way, vehicle);
  const double reaction = vehicle.pilot ? vehicle.pilot->reaction.to_seconds() : 0;
  const double expected = flight.duration.expected.to_seconds() + lost + reaction;
  const double most = flight.duration.most.to_seconds() + pilot_seconds(vehicle) +
                      (vehicle.hovers ? kMargin * lost : kCircles * circle_seconds(vehicle));
  return rounded(least, expected, most);
}

std::vector<double> expected_passages(const Way& way, const VehicleModel& vehicle,
                                      const Wind& wind) {
  std::vector<double> at(way.size(), 0);
  for (std::size_t i = 1; i < way.size(); ++i) {
    double turn = i > 1 ? kCorner * sharpness(way, i - 1) : kGathering;
    if (!vehicle.hovers) turn = 0;
    at[i] = at[i - 1] + leg_seconds(way[i - 1], way[i], vehicle, wind) +
            turn * gathering_seconds(vehicle);
  }
  return at;
}

Times takeoff_times(double height, const VehicleModel& vehicle, const Wind& wind) {
  const double settling = kSettling * vehicle.climb_rate / vehicle.acceleration;
  const double climb = height / vehicle.climb_rate;
  const double near = arrival_distance(vehicle, wind) / vehicle.climb_rate;
  return rounded(climb - near, climb + settling / 2,
                 kSlowVertical * climb + settling + pilot_seconds(vehicle));
}

Times landing_times(double height, const VehicleModel& vehicle) {
  const double flare = kFlare * vehicle.descent_rate / vehicle.acceleration;
  const double roll = vehicle.hovers ? 0 : gathering_seconds(vehicle);
  const double down = height / vehicle.descent_rate;
  const double near = 4 * world::tracking_spread(vehicle) / vehicle.descent_rate;
  return rounded(down - near, down + flare / 2,
                 kSlowVertical * down + flare + roll + pilot_seconds(vehicle));
}

Times waiting_times(double seconds, const VehicleModel& vehicle) {
  const double late = longest_reaction(vehicle);
  return {seconds, seconds + late / 2, seconds + late};
}

}  // namespace skein::supervisor
