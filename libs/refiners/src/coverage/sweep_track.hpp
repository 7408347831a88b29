// SPDX-License-Identifier: Apache-2.0
// A sweep as a line over the ground, then as a way in the air.
#pragma once

#include <optional>
#include <vector>

#include "coverage/sweep_detour.hpp"
#include "coverage/sweep_planner.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/terrain.hpp"

namespace skein::refiners {

/// Over the ground.
struct Track {
  std::vector<world::Vector2> points;
  std::size_t first = 0, last = 0;  ///< where the first lane begins and the last ends
  double seconds = 0;               ///< of the sweep, with what ways around obstacles add
};

/// Lanes, what joins them, and the ways from the start and to the end: straight or on a shortest
/// curve, or around obstacles where those are not free. Where no way around was found they lead
/// through: the caller must check.
Track track_of(const Sweep& sweep, const SweepEnds& ends, const TurnModel& model,
               const Obstacles& obstacles);

/// How high to fly a track.
struct Profile {
  double altitude = 0;               ///< over the ground [m]
  double tolerance = 0;              ///< by which the way may leave it between its points [m]
  std::optional<double> start, end;  ///< ENU z of where it comes from and goes to [m]
  double speed = 0;                  ///< [m/s]
  double steeper = 1;  ///< than it climbs and descends at that speed: one that hovers flies slower
};

/// Height over the ground that the way from a start so high over it has everywhere until the lanes,
/// and the way to such an end [m].
double least_lead(double altitude, double height);

/// The track at the altitude over the ground, within the tolerance between the points (and never
/// less than half as high as it should be); higher only where the vehicle could not climb or
/// descend as steeply as the ground does. A start or an end that is too high or low to be reached
/// on the way is left or reached on the spot: upright by a vehicle that hovers, else in circles.
Way raised(const Track& track, const Profile& profile, const world::VehicleModel& vehicle,
           const world::Terrain& terrain);

}  // namespace skein::refiners
