// SPDX-License-Identifier: Apache-2.0
#include "flight/flight_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "flight/autopilot.hpp"
#include "skein/world/steering.hpp"

namespace skein::supervisor {

namespace {

using refiners::Way;
using world::Vector3;
using world::VehicleModel;
using world::Wind;

// Of the vehicle's time to gather its speed, v / a (docs/comets-domain.md has what they come from):
constexpr double kBraking = 0.6;           // once more, at the end
constexpr double kCornerBraking = 0.25;    // at each corner;
constexpr double kEvenOut = 0.75;          // power of their number by which that grows
constexpr std::size_t kFlights = 6;        // in thought,
constexpr std::size_t kTightFlights = 24;  // where points may be missed, which is rare
constexpr double kLongFlight = 300;        // [s] beyond which what they differ by evens out
constexpr double kShare = 0.02;            // of any flight, either way
constexpr double kGustTime = 10;           // [s] over which gusts are as one
constexpr double kDrivingLoss = 1;         // [s] of a drive, at each corner and at its end
constexpr double kSettling = 4;            // of a climb, at its end
constexpr double kFlare = 6;               // of a descent, near the ground
constexpr double kJoining = 1.3;           // of its circle: it is joined from inside and outside
constexpr double kSlowVertical = 1.5;
constexpr double kCorrections = 6;        // of a pilot, before it is content
constexpr double kCorrectionsOnAWay = 4;  // of which it does the others in passing
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

/// Of all poses a way may begin in.
struct Span {
  double least = 0, expected = 0, most = 0;
  bool arrives = false;
};

/// Some leg is shorter than the circle that one that cannot hover makes room for: what is missed
/// there takes more than a turn.
bool is_tight(const Way& way, const VehicleModel& vehicle) {
  if (vehicle.hovers) return false;
  for (std::size_t i = 1; i < way.size(); ++i)
    if ((way[i] - way[i - 1]).head<2>().norm() < 2 * kRoomMargin * vehicle.min_turn_radius)
      return true;
  return false;
}

/// What a point that is missed takes, of a flight of so many seconds: one circle where the next leg
/// leaves room for it. Every flight in thought of a long way misses some already.
double missed_seconds(const Way& way, double flight, const VehicleModel& vehicle,
                      const Wind& wind) {
  if (flight >= kLongFlight || !is_tight(way, vehicle)) return circle_seconds(vehicle);
  return turning_back_seconds(vehicle, wind);
}

/// Flown in thought from each pose, with errors and gusts.
Span flown(const Way& way, const VehicleModel& vehicle, const Wind& wind) {
  const Way points(way.size() > 1 ? way.begin() + 1 : way.begin(), way.end());
  const std::vector<Pose> poses = poses_at(way.front(), vehicle);
  const std::size_t least = std::max(kFlights, poses.size());
  const std::size_t most = is_tight(way, vehicle) ? std::max(kTightFlights, least) : least;
  Span span{std::numeric_limits<double>::infinity(), 0, 0, true};
  for (std::size_t i = 0; i < most && (i < least || span.most < kLongFlight); ++i) {
    const FlownWay one = fly_way(poses[i % poses.size()], points, vehicle, wind, i + 1);
    span.arrives = span.arrives && one.arrived;
    span.least = std::min(span.least, one.seconds);
    span.most = std::max(span.most, one.seconds);
    // What is rare is not expected.
    if (i < least) span.expected += one.seconds / static_cast<double>(least);
  }
  return span;
}

/// Part of a flight that gusts may add to it or take from it: the longer it is, the more they even
/// out.
double gust_share(double seconds, const VehicleModel& vehicle, const Wind& wind) {
  const double whole = 3 * vehicle.wind_drift * wind.gusts / vehicle.cruise_speed;
  return kShare + whole * std::min(1.0, std::sqrt(kGustTime / std::max(1.0, seconds)));
}

/// Braking again where it was blown or flown off its way; or passing where it was blown on.
double corner_seconds(std::size_t corners, const VehicleModel& vehicle) {
  return kCornerBraking * std::pow(static_cast<double>(corners), kEvenOut) *
         gathering_seconds(vehicle);
}

}  // namespace

double arrival_distance(const VehicleModel& vehicle, const Wind& wind) {
  return 4 * world::tracking_spread(vehicle) + 2 * greatest_drift(vehicle, wind);
}

double waiting_reach(const VehicleModel& vehicle, const Wind& wind) {
  return arrival_distance(vehicle, wind) + (vehicle.hovers ? 0 : kJoining * vehicle.orbit_radius);
}

double stay_radius(const VehicleModel& vehicle) {
  return 3 * world::tracking_spread(vehicle) + (vehicle.hovers ? 0 : vehicle.orbit_radius);
}

double longest_reaction(const VehicleModel& vehicle) {
  if (!vehicle.pilot) return 0;
  return (vehicle.pilot->reaction + vehicle.pilot->reaction_spread).to_seconds() +
         2 * vehicle.pilot->reaction_spread.to_seconds();
}

double stray_distance(const VehicleModel& vehicle, const Wind& wind) {
  return 2 * std::numbers::sqrt2 * world::tracking_spread(vehicle) +
         2 * greatest_drift(vehicle, wind);
}

double turning_back_seconds(const VehicleModel& vehicle, const Wind& wind) {
  const double slowest = vehicle.cruise_speed - vehicle.wind_drift * (wind.speed + wind.gusts);
  const double round = 2 * std::numbers::pi * kRoomMargin * vehicle.min_turn_radius +
                       2 * world::reaching_distance(vehicle, wind);
  return round / std::max(slowest, vehicle.cruise_speed / 2);
}

Times flight_times(const Way& way, const VehicleModel& vehicle, const Wind& wind) {
  if (way.empty()) return {};
  if (vehicle.ground) return driving_times(way, vehicle);
  const Span span = flown(way, vehicle, wind);
  // Neither wavers nor is blown about, and needs no time to gather its speed: exactly so long.
  const bool is_exact = vehicle.hovers && gathering_seconds(vehicle) <= kTrackStep &&
                        stray_distance(vehicle, wind) <= 0 && !vehicle.pilot;
  if (is_exact) return rounded(span.least, span.expected, span.most);
  const double share = gust_share(span.expected, vehicle, wind);
  const double speed = vehicle.cruise_speed, near = stray_distance(vehicle, wind) / speed;
  const double reached = world::reaching_distance(vehicle, wind) / speed;
  const double corners = vehicle.hovers ? corner_seconds(way.size() - 1, vehicle) : 0;
  const double slowest = (1 + share) * span.most, quickest = (1 - share) * span.least;
  // A way that the autopilot does not come to the end of takes for ever.
  if (!span.arrives) return rounded(quickest / 2, span.expected, slowest);
  if (!vehicle.hovers) {
    const double fastest = speed + greatest_drift(vehicle, wind);
    const double straight =
        (least_length(way, arrival_distance(vehicle, wind)) - vehicle.orbit_radius) / fastest;
    return rounded(std::max(straight - reached, quickest - circle_seconds(vehicle) - near),
                   span.expected, slowest + missed_seconds(way, span.most, vehicle, wind) + near);
  }
  const double reaction = vehicle.pilot ? vehicle.pilot->reaction.to_seconds() : 0;
  const double pilot = vehicle.pilot
                           ? longest_reaction(vehicle) +
                                 kCorrectionsOnAWay * vehicle.pilot->attention_period.to_seconds()
                           : 0;
  return rounded(quickest - corners - near - reached, span.expected + reaction + corners / 2,
                 slowest + kBraking * gathering_seconds(vehicle) + corners + pilot);
}

Times driving_times(const Way& way, const VehicleModel& vehicle) {
  if (way.size() < 2) return {};
  double length = 0, turns = 1;  // in half turns; it gathers its speed and brakes at the ends
  for (std::size_t i = 1; i < way.size(); ++i) {
    const world::Vector2 in = (way[i] - way[i - 1]).head<2>();
    length += in.norm();
    if (i + 1 == way.size()) break;
    const world::Vector2 out = (way[i + 1] - way[i]).head<2>();
    const double lengths = in.norm() * out.norm();
    turns += lengths > 0 ? (1 - in.dot(out) / lengths) / 2 : 1;
  }
  const double calm = length / vehicle.cruise_speed, gathering = gathering_seconds(vehicle);
  const double near = world::reaching_distance(vehicle, {}) / vehicle.cruise_speed;
  const double points = static_cast<double>(way.size());
  return rounded(
      (1 - kShare) * calm - 2 * turns * near, calm + turns * gathering / 2,
      (1 + kShare) * calm + turns * gathering + points * kDrivingLoss + pilot_seconds(vehicle));
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
