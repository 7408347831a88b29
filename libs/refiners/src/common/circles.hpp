// SPDX-License-Identifier: Apache-2.0
// Full circles in which a vehicle that cannot hover climbs or descends over a place; private.
#pragma once

#include "skein/refiners/flight.hpp"
#include "skein/world/terrain.hpp"

namespace skein::refiners {

/// Greatest distance of chords from the sampled curve [m].
inline constexpr double kTurnTolerance = 0.5;

struct CircleRule {
  double slope = 0;   ///< the steepest [m/m], > 0
  double radius = 0;  ///< [m]
  double least = 0;   ///< height over the ground [m] that decides between the two sides
};

/// Adds full circles from `way.back()` up or down to the ENU height `to` over the same place. They
/// are flown on the left of the direction `ahead` (unit vector), or on the right if they would be
/// below `rule.least` on the left and less so on the right. Precondition: `to` differs from the
/// height of `way.back()`.
void add_circles(Way& way, double to, const world::Vector2& ahead, const CircleRule& rule,
                 const world::Terrain& terrain);

}  // namespace skein::refiners
