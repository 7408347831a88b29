// SPDX-License-Identifier: Apache-2.0
// The wind over the whole scenario.
#pragma once

#include "skein/world/geometry.hpp"

namespace skein::world {

/// A steady horizontal wind with gusts; the same everywhere, none vertical.
struct Wind {
  double toward = 0;  ///< where the air moves to [rad], ENU counter-clockwise from east
  double speed = 0;   ///< >= 0 [m/s]
  double gusts = 0;   ///< standard deviation of each horizontal component around the mean [m/s]
  bool operator==(const Wind&) const = default;
};

/// The mean motion of the air [m/s], ENU.
Vector3 mean_velocity(const Wind& wind);

}  // namespace skein::world
