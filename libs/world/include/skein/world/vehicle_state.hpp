// SPDX-License-Identifier: Apache-2.0
// Where a vehicle is and how it is.
#pragma once

#include <string>

#include "skein/world/geometry.hpp"

namespace skein::world {

struct VehicleState {
  Vector3 position = Vector3::Zero();  ///< [m], ENU
  Vector3 velocity = Vector3::Zero();  ///< over the ground [m/s], ENU
  double heading = 0;                  ///< (-π, π] [rad], ENU counter-clockwise from east
  double energy = 1;                   ///< what is left, [0, 1]
  bool airborne = false;
  std::string activity;  ///< for people: "on the ground", "goto 2/5", "orbit", …
  bool operator==(const VehicleState&) const = default;
};

}  // namespace skein::world
