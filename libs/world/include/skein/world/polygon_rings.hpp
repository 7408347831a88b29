// SPDX-License-Identifier: Apache-2.0
// Polygons as others write them: closed, or with more corners than are needed.
#pragma once

#include <optional>

#include "skein/world/polygon_check.hpp"

namespace skein::world {

/// Without the last corner where that is the first again, as GeoJSON, WKT and KML close their
/// rings.
Polygon without_closing_corner(Polygon ring);

struct SimplifiedPolygon {
  Polygon polygon;  ///< simple, of corners of the one that was given, in their order
  /// No point of either border is farther from the other [m]; 0: it is as it was given.
  double tolerance = 0;
};

/// With at most so many corners, leaving out those that matter least. Nothing when what is left
/// crosses itself however many are left out. Finite corners. Cost: O(n log n) as a rule, O(n²) at
/// worst, and the check of what is left (problem_of). Source: Douglas and Peucker 1973.
std::optional<SimplifiedPolygon> simplified(const Polygon& polygon,
                                            std::size_t most_corners = kMostCorners);

}  // namespace skein::world
