// SPDX-License-Identifier: Apache-2.0
// A sweep as a plane track, and its height profile.
#pragma once

#include <optional>
#include <vector>

#include "coverage/sweep_detour.hpp"
#include "coverage/sweep_planner.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/terrain.hpp"

namespace skein::refiners {

/// A sweep as a plane path.
struct Track {
  std::vector<world::Vector2> points;
  std::size_t first = 0, last = 0;  ///< where the first lane begins and the last ends
  double seconds = 0;               ///< of the sweep, including detours around obstacles
};

/// Lanes, the turns between them, and the legs from the start and to the end: straight or on a
/// shortest curve, or around obstacles where those are not free. If no detour was found the track
/// leads through the obstacle: the caller must check.
Track track_of(const Sweep& sweep, const SweepEnds& ends, const TurnModel& model,
               const Obstacles& obstacles);

/// Parameters of the height profile.
struct Profile {
  double altitude = 0;               ///< over the ground [m]
  double tolerance = 0;              ///< deviation from `altitude` between the points [m]
  std::optional<double> start, end;  ///< ENU z of the places before and after the sweep [m]
  double speed = 0;                  ///< [m/s]
  double steeper =
      1;  ///< factor on the slopes at that speed, for hovering vehicles, which slow down
};

/// Least height over the ground [m] of the leg between the lanes and a start or end that is
/// `height` over the ground.
double least_lead(double altitude, double height);

/// The track at the altitude over the ground, within the tolerance between the points (and never
/// below half the altitude); higher only where the ground is steeper than the vehicle climbs or
/// descends. A height difference at the start or end that is too large for the leg is flown on the
/// spot: vertically by a hovering vehicle, else in circles.
Way raised(const Track& track, const Profile& profile, const world::VehicleModel& vehicle,
           const world::Terrain& terrain);

}  // namespace skein::refiners
