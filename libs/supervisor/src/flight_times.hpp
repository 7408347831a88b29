// SPDX-License-Identifier: Apache-2.0
// How long a vehicle really takes along a way: the refiners' estimates know neither acceleration
// nor turns, nor who flies.
#pragma once

#include <cstddef>
#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::supervisor {

/// [s], as doubles: they become terms of the planner. `least` and `most` are whole tenths of a
/// second, rounded outwards, so that plans can be read and compared.
struct Times {
  double least = 0, expected = 0, most = 0;
};

/// How far from where it is meant to be a vehicle may be taken to have arrived [m].
double arrival_distance(const world::VehicleModel& vehicle, const world::Wind& wind);

/// How far it gets from where it stays: what it wavers, and its waiting circle [m].
double stay_radius(const world::VehicleModel& vehicle);

/// Longest time from an order to its effect [s]; 0 without a pilot.
double longest_reaction(const world::VehicleModel& vehicle);

/// A way flown at cruise speed, from rest to rest.
///
/// `least`: the shortest way that touches every way-point within arrival_distance, at cruise speed
/// with the strongest wind (three deviations of its gusts) behind. `expected`: the refiners'
/// estimate, and gathering speed, braking, and turning at every corner in proportion to how sharp
/// it is; of a vehicle that cannot hover, half a circle instead. `most`: the refiners' estimate
/// against the wind, and three times as much; with a pilot, the longest reaction and six
/// corrections; of a vehicle that cannot hover, five full circles, for headings and heights that do
/// not fit. Checked against the functional simulator (test/flown_times_test.cpp). Cost: O(points).
Times flight_times(const refiners::Way& way, const world::VehicleModel& vehicle,
                   const world::Wind& wind);
/// Expected seconds at each way-point since the first one, as flight_times counts them.
std::vector<double> expected_passages(const refiners::Way& way, const world::VehicleModel& vehicle,
                                      const world::Wind& wind);

/// Straight up, or straight down to the ground, over `height` metres.
Times takeoff_times(double height, const world::VehicleModel& vehicle, const world::Wind& wind);
Times landing_times(double height, const world::VehicleModel& vehicle);

/// A wait of so many seconds: a pilot begins it late.
Times waiting_times(double seconds, const world::VehicleModel& vehicle);

}  // namespace skein::supervisor
