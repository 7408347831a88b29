// SPDX-License-Identifier: Apache-2.0
// How much air a vehicle reserves around its intended path.
#pragma once

#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"

namespace skein::merging {

/// Distances from the intended path [m]. Each includes half of the separation between two vehicles
/// (world::separation_share), so vehicles whose volumes do not overlap keep the full separation.
struct Margins {
  bool hovers = true;
  /// Horizontal radius around a place where the vehicle hovers, circles, climbs or lands, and
  /// around the line on which it departs, so that a holding vehicle can always climb.
  double hold = 0;
  double way = 0;      ///< horizontal radius around a line that is flown, with stops on it
  double settled = 0;  ///< within this distance [m] of its holding place `hold` is enough
  double level = 0;    ///< vertical, in level flight and while holding
  double slope = 0;    ///< vertical, while climbing or descending
  double stretch = 0;  ///< longest piece [m] of a way, > 0; pieces are released one by one
  /// Longest leg [m] without an intermediate way-point, at least `stretch`: bounds the drift by
  /// wind. A helicopter slows down at each way-point; a vehicle that cannot hover would circle one
  /// that is too near to the last for its turns, so none is inserted where less than half of this
  /// length remains.
  double steered = 0;
  double apart = 0;  ///< the half of the horizontal separation that all these include
};

/// `speed`: airspeed [m/s]. Wind counts with its mean and three standard deviations of its gusts.
/// The figures assume that vehicles steer towards the next way-point instead of tracking the line;
/// tests/corridor flies the simulator's vehicles against them.
Margins margins_of(const world::VehicleModel& model, const world::Wind& wind, double speed);

}  // namespace skein::merging
