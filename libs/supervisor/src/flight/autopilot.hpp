// SPDX-License-Identifier: Apache-2.0
// How a vehicle really flies a way: as a point mass that is steered from way-point to way-point.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/refiners/flight.hpp"

namespace skein::supervisor {

/// Where a flight begins. `speed` is through the air [m/s], `heading` in radians.
struct Pose {
  world::Vector3 at = world::Vector3::Zero();
  double heading = 0;
  double speed = 0;
};

/// What became of a flight.
struct FlownWay {
  std::vector<world::Vector3> track;  ///< every kTrackStep seconds, from the start on
  std::vector<double> passages;       ///< when each way-point was reached [s]
  bool arrived = false;               ///< else its patience was at an end
  double seconds = 0;                 ///< until it arrived
  Pose end;
};

inline constexpr double kTrackStep = 0.1;  ///< [s]
/// Room is made until a turn this much wider than the tightest leads to a point.
inline constexpr double kRoomMargin = 1.5;

/// The feedback laws that autopilots and pilots fly by: one
/// that hovers goes straight at each point, braking for corners and at the end; one that does not
/// steers at the next point within its turns, and flies straight on first to make room where a
/// turn would miss it. One without inertia worth speaking of flies exactly its way. Level ground is
/// assumed. `way`: what is flown to, without where it begins.
///
/// `trial` 0: without errors of tracking and without gusts; others: each with errors and gusts of
/// its own, of the size that the model and the wind say. The same trial is the same flight. Cost:
/// 0.1 µs for each kTrackStep.
FlownWay fly_way(const Pose& from, const refiners::Way& way, const world::VehicleModel& vehicle,
                 const world::Wind& wind, std::uint64_t trial = 0);

/// The circles that one that cannot hover flies around a place for so many seconds.
std::vector<world::Vector3> circle_over(const Pose& from, const world::Vector3& at,
                                        const world::VehicleModel& vehicle, const world::Wind& wind,
                                        double seconds);

/// Where a vehicle may be and head to that is said to be at a place: there at rest, if it hovers;
/// else passing it towards anywhere, or anywhere on its waiting circle.
std::vector<Pose> poses_at(const world::Vector3& at, const world::VehicleModel& vehicle);

}  // namespace skein::supervisor
