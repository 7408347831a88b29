// SPDX-License-Identifier: Apache-2.0
// How much air a vehicle takes around what it means to fly.
#pragma once

#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"

namespace skein::merging {

/// Distances from what is meant [m], each with half of the separation that two vehicles keep
/// (world::separation_share): where volumes of two do not overlap, they keep all of it.
struct Margins {
  bool hovers = true;
  /// Level, around a place where it holds or circles, rises or lands, and around a line on which it
  /// leaves: so that whoever holds can always go up.
  double hold = 0;
  double way = 0;      ///< level, around a line it flies along, and may stop on
  double settled = 0;  ///< it is this near [m] to where it holds: `hold` is enough
  double level = 0;    ///< in height, where it flies level or holds
  double slope = 0;    ///< in height, where its way rises or falls
  double stretch = 0;  ///< longest piece [m] of a way, > 0: left one by one
  /// Longest way [m] without a way-point, at least `stretch`: wind carries it off. A helicopter
  /// slows at each, while it holds its height; one that cannot hover circles a point that is too
  /// near to the last for its turns, so a way gets none in between where less than half of this is
  /// left.
  double steered = 0;
};

/// At a speed through the air [m/s]. Wind: its mean and three deviations of its gusts count.
/// The figures follow how a vehicle is steered at a point and not along a line; tests/corridor
/// flies the simulator's vehicles against them.
Margins margins_of(const world::VehicleModel& model, const world::Wind& wind, double speed);

}  // namespace skein::merging
