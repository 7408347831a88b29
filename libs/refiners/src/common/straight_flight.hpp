// SPDX-License-Identifier: Apache-2.0
// Fast duration of straight flights: estimate_flight for two places, for millions of calls.
#pragma once

#include <cstdint>

#include "skein/refiners/flight.hpp"

namespace skein::refiners {

/// The whole number nearest to one in [0, 2^62], halves up: std::llround without a call.
inline std::int64_t nearest_whole(double value) {
  const auto below = static_cast<std::int64_t>(value);
  return below + (value - static_cast<double>(below) >= 0.5 ? 1 : 0);
}

/// Precomputes the terms common to all flights. The vehicle must outlive this object.
class StraightFlight {
 public:
  /// `speed` 0: cruise.
  StraightFlight(const world::VehicleModel& vehicle, const world::Wind& wind, double speed);

  /// The expected time of estimate_flight({from, to}) [s]; infinite if the flight never ends.
  double seconds(const world::Vector3& from, const world::Vector3& to) const;

 private:
  const world::VehicleModel* vehicle_;
  double airspeed_;
  world::Vector2 drift_;
};

}  // namespace skein::refiners
