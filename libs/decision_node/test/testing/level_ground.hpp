// SPDX-License-Identifier: Apache-2.0
// A world of level ground, a kilometre each way.
#pragma once

#include "skein/world/world_builder.hpp"

namespace skein::decision_node::testing {

/// With a radio that reaches as far; what is to be otherwise is set by who builds it.
inline world::WorldFile level_ground() {
  world::WorldFile file;
  file.origin = world::GeodeticOrigin{};
  world::TerrainSpec terrain;
  terrain.west = terrain.south = -500;
  terrain.east = terrain.north = 500;
  file.terrain = terrain;
  file.radio.range = 1000;
  return file;
}

}  // namespace skein::decision_node::testing
