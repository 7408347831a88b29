// SPDX-License-Identifier: Apache-2.0
// A named area of the map.
#pragma once

#include <string>

#include "skein/world/geometry.hpp"

namespace skein::world {

struct Zone {
  std::string name;
  Polygon polygon;
};

}  // namespace skein::world
