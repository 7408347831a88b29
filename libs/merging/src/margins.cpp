// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/margins.hpp"

#include <algorithm>
#include <cmath>

#include "skein/world/separation.hpp"
#include "skein/world/steering.hpp"

namespace skein::merging {

namespace {

constexpr double kStretch = 50;   // [m]
constexpr double kLongest = 1e6;  // [m] between two way-points
constexpr double kTurns = 4;      // turn radii: half of it is room for a turn to a point
constexpr double kCarried = 2;    // [m] off the line, that wind may carry for fewer way-points
constexpr double kMargin = 1.5;   // [m] for what is overshot

/// How far beyond a bend a vehicle is carried [m], at the worst bend: it takes it at the speed
/// v (1 + cos) / 2 and turns what of that is across with all of its acceleration.
double carried_at_bends(const world::VehicleModel& model, double speed) {
  constexpr double kWorst = 0.42;  // of ((1 + cos) / 2 · sin)²
  return kWorst * world::braking_distance(model, speed);
}

/// Who steers at the point ahead, so far away, in a side wind is carried off the line by w/v · L/e
/// at the most.
double carried_by_wind(double drift, double speed, double ahead = kStretch) {
  return 0.37 * ahead * drift / speed;
}

/// The longest way between two way-points on which wind carries no further than kCarried, or as far
/// as over one piece.
double steered_at(double drift, double speed) {
  const double carried = carried_by_wind(drift, speed, 1);
  return carried > 0 ? std::clamp(kCarried / carried, kStretch, kLongest) : kLongest;
}

}  // namespace

Margins margins_of(const world::VehicleModel& model, const world::Wind& wind, double speed) {
  const world::Separation share = world::separation_share(model);
  const double spread = world::tracking_spread(model);
  const double drift = model.wind_drift * (wind.speed + 3 * wind.gusts);
  // Errors are cut at two deviations of each of two axes; in height half as large.
  // Who circles overshoots its height and its circle when it begins to.
  const double overshoots = model.hovers ? kMargin : 2 * kMargin;
  const double wavers = 2 * std::sqrt(2.0) * spread + overshoots;
  const double wavers_up = spread + overshoots;
  const double reached = world::reaching_distance(model, wind);
  Margins margins;
  margins.hovers = model.hovers;
  margins.apart = share.level;
  margins.stretch = margins.steered = kStretch;
  margins.level = wavers_up + share.height;
  margins.slope = reached + wavers_up + share.height;
  if (model.hovers) {
    const double held = drift / world::kPositionGain;
    margins.settled = wavers + held;
    const double rising = carried_by_wind(drift, model.climb_rate);
    margins.hold = wavers + held + share.level + rising;
    margins.steered = steered_at(drift, speed);
    margins.way = std::max(reached, carried_at_bends(model, speed)) +
                  carried_by_wind(drift, speed, margins.steered) + margins.hold;
  } else {
    margins.steered = std::max(kStretch, kTurns * model.min_turn_radius);
    const double circle = model.orbit_radius + 2 * drift;
    margins.settled = circle + wavers;
    // It comes off its circle when it rises, and circles elsewhere when it is stopped.
    const double rising = reached + model.min_turn_radius;
    margins.hold = 1.6 * circle + wavers + share.level + rising;
    margins.way = 1.1 * circle + 3 * model.min_turn_radius +
                  carried_by_wind(drift, speed, margins.steered) + wavers + reached + share.level;
  }
  return margins;
}

}  // namespace skein::merging
