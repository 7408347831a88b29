// SPDX-License-Identifier: Apache-2.0
// The points of the ground whose heights the operators' page is given.
#pragma once

#include "skein/world/grid.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground_setup {

/// The points are the middles of its cells, the first one the south-west corner of the terrain; at
/// most 160 along each side.
world::Grid page_grid(const world::TerrainSpec& spec);

}  // namespace skein::ground_setup
