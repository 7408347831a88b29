// SPDX-License-Identifier: Apache-2.0
// Duration and energy of a flight along a path.
#pragma once

#include <vector>

#include "skein/refiners/refinement.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/wind.hpp"

namespace skein::refiners {

/// Path: way-points in flight order, joined by straight legs [m], ENU.
using Way = std::vector<world::Vector3>;

struct Flight {
  double length = 0;  ///< [m]
  DurationInterval duration;
  double energy = 0;  ///< used in the expected duration, as a fraction of the full capacity
};

/// A flight without stops: each leg takes the longer time of its horizontal part, at `speed` (0:
/// cruise), and its vertical part, at the full climb or descent rate. The vehicle holds its track
/// against the wind, which counts by the vehicle's drift (VehicleModel::wind_drift): `expected`
/// with the mean wind on each leg, `least` at the greatest speed with a tailwind of the mean and
/// one standard deviation of the gusts all along, `most` at `speed` with the same as headwind. A
/// leg against a wind as fast as the vehicle never ends: Duration::max(). Turns add nothing. Cost:
/// O(points). Preconditions: finite points; check_vehicle passes.
Flight estimate_flight(const Way& way, const world::VehicleModel& vehicle, const world::Wind& wind,
                       double speed = 0);

double length_of(const Way& way);

}  // namespace skein::refiners
