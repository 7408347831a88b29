// SPDX-License-Identifier: Apache-2.0
// How high a plane way is flown: over the ground, no steeper than the vehicle climbs.
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

/// How far from the wanted altitude a leg may run, as a part of it: fewer points.
inline constexpr double kHeightTolerance = 0.1;

/// The plane way without its collinear points, at the least heights that keep the rule: at
/// `altitude` over the ground, more where the ground is too steep to be followed. The first and
/// last points are kept, unless the time is up.
Way over_ground(const std::vector<world::Vector2>& way, const world::Terrain& terrain,
                const HeightRule& rule, Deadline& deadline);

/// Drops points within a straight stretch. Cost: O(points).
std::vector<world::Vector2> without_collinear(const std::vector<world::Vector2>& way);

/// The first `length` metres of a plane way.
std::vector<world::Vector2> first_part(const std::vector<world::Vector2>& way, double length);

}  // namespace skein::refiners
