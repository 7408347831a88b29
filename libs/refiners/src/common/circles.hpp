// SPDX-License-Identifier: Apache-2.0
// Circles by which a vehicle that cannot hover changes its height over a place; private.
#pragma once

#include "skein/refiners/flight.hpp"

namespace skein::refiners {

/// Curves are made of chords that leave them by no more [m].
inline constexpr double kTurnTolerance = 0.5;

/// Adds whole circles from `way.back()` up or down to the ENU height `to` over the same place, left
/// of where the way goes on: `ahead`, a unit vector. `slope` is the steepest [m/m], > 0. They begin
/// and end there. Precondition: that is another height.
void add_circles(Way& way, double to, const world::Vector2& ahead, double slope, double radius);

}  // namespace skein::refiners
