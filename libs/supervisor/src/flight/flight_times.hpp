// SPDX-License-Identifier: Apache-2.0
// How long a vehicle really takes along a way: the refiners' estimates know neither acceleration
// nor turns, nor who flies.
#pragma once

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

/// How far a vehicle may be beside where its autopilot means it to be: two deviations of its
/// tracking along each axis, and what the strongest wind displaces it [m].
double stray_distance(const world::VehicleModel& vehicle, const world::Wind& wind);

/// A way flown at cruise speed, from where it waits to where it waits: `expected` as the autopilot
/// flies it (autopilot.hpp), on average over the poses in which it may begin. `least` and `most`
/// are the quickest and the slowest of them and what gusts, tracking and the pilot may add or take:
/// of one that hovers, braking once more at some corners; else a full circle, for a point that is
/// missed or for once met (a wider one where the way has legs too short to turn in).
/// docs/comets-domain.md has the figures; tests/scenarios/flown_times_test.cpp flies them. Cost:
/// six to eight flights by the autopilot, up to 24 of ways with such legs.
Times flight_times(const refiners::Way& way, const world::VehicleModel& vehicle,
                   const world::Wind& wind);

/// Of a vehicle that keeps to the ground: its cruise speed is over the map, whatever the ground
/// does; it brakes for corners, and gathers its speed again behind them.
Times driving_times(const refiners::Way& way, const world::VehicleModel& vehicle);

/// What a point costs one that cannot hover when it is missed between legs too short to turn in:
/// straight on first and then around, held against the wind [s].
double turning_back_seconds(const world::VehicleModel& vehicle, const world::Wind& wind);

/// Straight up, or straight down to the ground, over `height` metres.
Times takeoff_times(double height, const world::VehicleModel& vehicle, const world::Wind& wind);
Times landing_times(double height, const world::VehicleModel& vehicle);

/// A wait of so many seconds: a pilot begins it late.
Times waiting_times(double seconds, const world::VehicleModel& vehicle);

}  // namespace skein::supervisor
