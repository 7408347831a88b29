// SPDX-License-Identifier: Apache-2.0
// Durations of flights, with what the refiners' estimates leave out: acceleration, turns, pilots.
#pragma once

#include "skein/mission/elementary_plan.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::supervisor {

/// A duration [s], as doubles, since they become terms of the planner. `least` and `most` are
/// rounded outwards to tenths of a second, so that plans can be read and compared.
struct Times {
  double least = 0, expected = 0, most = 0;
};

/// Within this distance of its destination a vehicle may report to have arrived [m].
double arrival_distance(const world::VehicleModel& vehicle, const world::Wind& wind);

/// Bound on the distance from a waiting place, while waiting and while joining the circle [m].
double waiting_reach(const world::VehicleModel& vehicle, const world::Wind& wind);

/// Bound on a waiting vehicle's distance from its waiting place: three standard deviations of its
/// tracking and, if it cannot hover, the radius of its circle [m].
double stay_radius(const world::VehicleModel& vehicle);

/// Longest time from an order to its effect [s]; 0 without a pilot.
double longest_reaction(const world::VehicleModel& vehicle);

/// Bound on a vehicle's deviation from its intended path: two standard deviations of its tracking
/// along each axis, plus the displacement by the strongest wind [m].
double stray_distance(const world::VehicleModel& vehicle, const world::Wind& wind);

/// Duration of a way flown at cruise speed, from waiting to waiting. `expected`: by simulation
/// (autopilot.hpp), on average over the poses in which the flight may begin. `least` and `most`:
/// the quickest and the slowest of these flights, with the effects of gusts, tracking and the
/// pilot: for a vehicle that hovers, braking once more at some corners; else a full circle for a
/// missed way-point (a wider one if the way has legs too short to turn in). docs/comets-domain.md
/// has the figures; tests/scenarios/flown_times_test.cpp flies them. Cost: six to eight simulated
/// flights, up to 24 for ways with such legs.
Times flight_times(const refiners::Way& way, const world::VehicleModel& vehicle,
                   const world::Wind& wind);

/// Duration of a way driven by a ground vehicle: its cruise speed counts horizontally, whatever the
/// slope; it brakes for corners and accelerates behind them.
Times driving_times(const refiners::Way& way, const world::VehicleModel& vehicle);

/// Time that a vehicle that cannot hover needs to return to a way-point missed between legs too
/// short to turn in: straight on first, then around, against the wind [s].
double turning_back_seconds(const world::VehicleModel& vehicle, const world::Wind& wind);

/// Durations of a vertical takeoff and of a vertical landing over `height` [m].
Times takeoff_times(double height, const world::VehicleModel& vehicle, const world::Wind& wind);
Times landing_times(double height, const world::VehicleModel& vehicle);

/// Duration of a wait of so many seconds, including the reaction time of a pilot.
Times waiting_times(double seconds, const world::VehicleModel& vehicle);

}  // namespace skein::supervisor
