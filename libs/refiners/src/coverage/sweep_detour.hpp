// SPDX-License-Identifier: Apache-2.0
// Paths around volumes between the lanes of a sweep.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::refiners {

/// The obstacles at the height of the lanes.
struct Obstacles {
  /// Whether the straight segment is free.
  std::function<bool(const world::Vector2&, const world::Vector2&)> is_free;
  std::vector<world::Polygon> outlines;
};

/// The shortest line around the hulls of the outlines that keeps a margin from their corners, both
/// ends among its points; nothing when there is none, or there are more than a few hundred corners.
/// Cost: O(corners² × checks). Precondition: margin > 0.
std::optional<std::vector<world::Vector2>> way_around(const Obstacles& obstacles,
                                                      const world::Vector2& from,
                                                      const world::Vector2& to, double margin);

}  // namespace skein::refiners
