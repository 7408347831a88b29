// SPDX-License-Identifier: Apache-2.0
// Back-and-forth sweeps over a zone.
#pragma once

#include <optional>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::ground_station {

/// The way points [m, ENU] of a boustrophedon over `zone`, in flying order, two per leg. Legs are
/// parallel to the edge for which the fewest are needed, at most `spacing` apart; deterministic.
///
/// Laws, for any simple polygon: every point of the zone is within spacing / 2 of a leg, and every
/// point of a leg is within spacing / 2 of the zone (legs reach as far as the strip they cover).
/// Between two legs of a zone that is not convex the way may leave the zone.
///
/// With `start`, the sweep begins on the leg nearest to it, goes to the nearer side of the zone,
/// then does the other side. Without, it begins at one side of the zone.
///
/// Empty when the polygon has fewer than three vertices, no area or a vertex that is not finite,
/// when `spacing` is not positive, or when more than 10,000 legs would be needed. Cost: O(vertices²
/// + legs × vertices). Source: T VI.1.2 (detection, mapping).
std::vector<world::Vector2> boustrophedon(const world::Polygon& zone, double spacing,
                                          std::optional<world::Vector2> start = std::nullopt);

}  // namespace skein::ground_station
