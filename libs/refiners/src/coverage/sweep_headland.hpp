// SPDX-License-Identifier: Apache-2.0
// The strip along the border of an area in which turns are flown.
#pragma once

#include <vector>

#include "coverage/turn_model.hpp"
#include "skein/refiners/coverage.hpp"

namespace skein::refiners {

/// The part of a convex polygon at least `width` from its border, counter-clockwise; fewer than
/// three corners if it is empty. Cost: O(corners²). Precondition: convex, counter-clockwise.
world::Polygon without_headland(const world::Polygon& area, double width);

/// One lap inside a convex polygon, half a swath from its border, beginning near `from`; lanes are
/// extended at corners until their strips meet, as far as the border permits. Precondition: convex,
/// counter-clockwise.
std::vector<Pass> border_lap(const world::Polygon& area, double swath, const world::Vector2& from);

/// Whether the path from the first lane to the last is entirely inside a convex polygon.
/// Precondition: convex, counter-clockwise.
bool sweeps_within(const world::Polygon& area, const Coverage& coverage);

}  // namespace skein::refiners
