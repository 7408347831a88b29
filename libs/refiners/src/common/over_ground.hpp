// SPDX-License-Identifier: Apache-2.0
// Height profile of a plane path: over the ground, no steeper than the vehicle climbs.
#pragma once

#include <vector>

#include "common/deadline.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/terrain.hpp"

namespace skein::refiners {

struct HeightRule {
  double altitude = 0;  ///< over the ground, at least [m]
  double climb = 0;     ///< greatest slope up [m/m], > 0
  double descent = 0;   ///< greatest slope down, as a positive figure, > 0
};

/// Tolerated deviation from the altitude along a leg, as a fraction of the altitude; saves points.
inline constexpr double kHeightTolerance = 0.1;

/// The plane path without collinear points, at the least heights that satisfy the rule: `altitude`
/// over the ground, more where the ground is too steep to follow. First and last points are kept,
/// unless the time is up.
Way over_ground(const std::vector<world::Vector2>& way, const world::Terrain& terrain,
                const HeightRule& rule, Deadline& deadline);

/// Removes the inner points of straight stretches. Cost: O(points).
std::vector<world::Vector2> without_collinear(const std::vector<world::Vector2>& way);

/// The first `length` metres of a plane way.
std::vector<world::Vector2> first_part(const std::vector<world::Vector2>& way, double length);

}  // namespace skein::refiners
