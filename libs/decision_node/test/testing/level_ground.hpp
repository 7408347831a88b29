// SPDX-License-Identifier: Apache-2.0
// A world of level ground.
#pragma once

#include "skein/world/world_builder.hpp"

namespace skein::decision_node::testing {

/// So far [m] to each side of its origin, with a radio that reaches a kilometre; what is to be
/// otherwise is set by who builds it.
inline world::WorldFile level_ground(double far = 500) {
  world::WorldFile file;
  file.origin = world::GeodeticOrigin{};
  world::TerrainSpec terrain;
  terrain.west = terrain.south = -far;
  terrain.east = terrain.north = far;
  file.terrain = terrain;
  file.radio.range = 1000;
  return file;
}

}  // namespace skein::decision_node::testing
