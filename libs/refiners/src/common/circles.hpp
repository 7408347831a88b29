// SPDX-License-Identifier: Apache-2.0
// Circles by which a vehicle that cannot hover changes its height over a place; private.
#pragma once

#include "skein/refiners/flight.hpp"
#include "skein/world/terrain.hpp"

namespace skein::refiners {

/// Curves are made of chords that leave them by no more [m].
inline constexpr double kTurnTolerance = 0.5;

struct CircleRule {
  double slope = 0;   ///< the steepest [m/m], > 0
  double radius = 0;  ///< [m]
  double least = 0;   ///< height over the ground, where one side has it and the other has not [m]
};

/// Adds whole circles from `way.back()` up or down to the ENU height `to` over the same place, left
/// of where the way goes on (`ahead`, a unit vector), or right of it where they are too low on the
/// left and less so there. They begin and end there. Precondition: that is another height.
void add_circles(Way& way, double to, const world::Vector2& ahead, const CircleRule& rule,
                 const world::Terrain& terrain);

}  // namespace skein::refiners
