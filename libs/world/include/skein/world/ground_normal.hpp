// SPDX-License-Identifier: Apache-2.0
// Which way the ground faces.
#pragma once

#include "skein/world/terrain.hpp"

namespace skein::world {

/// Upwards at right angles to the ground, of unit length; from its slopes across one cell around
/// the place, so that it does not jump at the borders of cells. Straight up off the terrain. O(1).
Vector3 ground_normal(const Terrain& terrain, double x, double y);

}  // namespace skein::world
