// SPDX-License-Identifier: Apache-2.0
// How long a vehicle takes along a way, and what energy it draws.
#pragma once

#include <vector>

#include "skein/refiners/refinement.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"

namespace skein::refiners {

/// Way-points in the order they are flown, straight in between [m], ENU.
using Way = std::vector<world::Vector3>;

struct Flight {
  double length = 0;  ///< [m]
  DurationInterval duration;
  double energy = 0;  ///< drawn in the expected duration, as a fraction of what is held when full
};

/// A way flown without stops: each leg takes as long as the slower of its horizontal part, at the
/// speed asked for (0: cruise), and its vertical part, at the full climb or descent rate. The wind
/// counts as far as the vehicle drifts with it (VehicleModel::wind_drift), which holds its track
/// against it: `expected` with the mean wind on each leg, `least` at the greatest speed with wind
/// and one deviation of its gusts behind all along, `most` at the speed asked for with as much
/// against it. A leg against a wind as fast as the vehicle takes for ever: Duration::max().
/// Nothing is added for turns. Cost: O(points). Preconditions: finite points; check_vehicle passes.
Flight estimate_flight(const Way& way, const world::VehicleModel& vehicle, const world::Wind& wind,
                       double speed = 0);

double length_of(const Way& way);

}  // namespace skein::refiners
