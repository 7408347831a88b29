// SPDX-License-Identifier: Apache-2.0
// The strip along the border of an area in which turns are flown.
#pragma once

#include <vector>

#include "coverage/turn_model.hpp"
#include "skein/refiners/coverage.hpp"

namespace skein::refiners {

/// What of a convex polygon is at least `width` from its border; fewer than three corners where
/// nothing is. Counter-clockwise. Cost: O(corners²). Precondition: convex, counter-clockwise.
world::Polygon without_headland(const world::Polygon& area, double width);

/// Once around within a convex polygon, half a swath from its border, beginning near `from`; at
/// corners as far on as the strips need to meet, or the border allows. Precondition: convex,
/// counter-clockwise.
std::vector<Pass> border_lap(const world::Polygon& area, double swath, const world::Vector2& from);

/// True when no point of the way between its first lane and its last is outside of a convex
/// polygon. Precondition: convex, counter-clockwise.
bool sweeps_within(const world::Polygon& area, const Coverage& coverage);

}  // namespace skein::refiners
