// SPDX-License-Identifier: Apache-2.0
// A world for tests that need no other: level ground, nothing in it.
#pragma once

#include "skein/world/world.hpp"

namespace skein::testing {

/// Ground at 0 m, from -`reach` to `reach` [m] either way, in cells of 20 m; no airspace.
inline world::World level_world(double reach) {
  world::TerrainSpec ground;
  ground.west = ground.south = -reach;
  ground.east = ground.north = reach;
  return {{}, world::Terrain(ground), {}, {}, {}, {}, {}, {}, {}};
}

}  // namespace skein::testing
