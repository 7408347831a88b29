// SPDX-License-Identifier: Apache-2.0
// A simple polygon as triangles.
#pragma once

#include <array>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::sampling {

/// Counter-clockwise triangles that fill the polygon (either sense, concave too) and do not
/// overlap; ones without area are left out. By clipping ears. Cost: O(corners³) at worst,
/// O(corners²) as a rule.
std::vector<std::array<world::Vector2, 3>> triangles_of(const world::Polygon& polygon);

}  // namespace skein::sampling
