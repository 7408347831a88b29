// SPDX-License-Identifier: Apache-2.0
// Where a vehicle is, or will be.
#pragma once

#include "skein/world/geometry.hpp"

namespace skein::supervisor {

struct Whereabouts {
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU
  bool airborne = false;
};

}  // namespace skein::supervisor
