// SPDX-License-Identifier: Apache-2.0
// Simulated flight along a way: a point mass that is steered from way-point to way-point.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/refiners/flight.hpp"

namespace skein::supervisor {

/// State of a vehicle at the beginning or end of a flight: position [m, ENU], heading [rad],
/// airspeed [m/s].
struct Pose {
  world::Vector3 at = world::Vector3::Zero();
  double heading = 0;
  double speed = 0;
};

/// Result of a simulated flight.
struct FlownWay {
  std::vector<world::Vector3> track;  ///< every kTrackStep seconds, from the start on
  std::vector<double> passages;       ///< when each way-point was reached [s]
  bool arrived = false;               ///< false: the simulation was given up after its time limit
  double seconds = 0;                 ///< until it arrived
  Pose end;
};

inline constexpr double kTrackStep = 0.1;  ///< [s]
/// A vehicle that cannot hover flies straight on until a turn of this many times its tightest
/// radius leads to the next way-point.
inline constexpr double kRoomMargin = 1.5;

/// Simulates the feedback laws of autopilots and pilots. A vehicle that hovers flies straight to
/// each way-point and brakes for corners and at the end. One that cannot hover steers towards the
/// next way-point within its turn radius, and first flies straight on where a turn would miss it. A
/// vehicle with negligible inertia flies exactly the way. Level ground is assumed. `way`: the
/// way-points, without the starting position.
///
/// `trial` 0: without tracking errors and gusts; other values seed random errors and gusts of the
/// magnitudes in the model and the wind. The same trial gives the same flight. Cost: 0.1 µs for
/// each kTrackStep.
FlownWay fly_way(const Pose& from, const refiners::Way& way, const world::VehicleModel& vehicle,
                 const world::Wind& wind, std::uint64_t trial = 0);

/// The track of a vehicle that cannot hover while it circles around `at` for so many seconds.
std::vector<world::Vector3> circle_over(const Pose& from, const world::Vector3& at,
                                        const world::VehicleModel& vehicle, const world::Wind& wind,
                                        double seconds);

/// Poses that a vehicle may have when it counts as being at a place: at rest there if it hovers;
/// else passing the place with any heading, or anywhere on its waiting circle: in so many
/// directions.
std::vector<Pose> poses_at(const world::Vector3& at, const world::VehicleModel& vehicle,
                           int headings = 4);

}  // namespace skein::supervisor
