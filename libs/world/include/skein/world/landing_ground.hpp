// SPDX-License-Identifier: Apache-2.0
// Where a vehicle may touch the ground: the one rule of vehicles and of who plans for them.
#pragma once

#include <optional>
#include <string>

#include "skein/world/terrain.hpp"

namespace skein::world {

/// No vehicle lands on ground that slopes by more [rad].
inline constexpr double kSteepestLanding = 0.2;

/// Why no vehicle lands at that point: outside the terrain, or too steep; nothing when one does.
/// Cost: O(1).
std::optional<std::string> landing_problem(const Terrain& terrain, const Vector2& at);

/// The same for all points within `radius` [m] of it, for who does not touch down where it meant
/// to: the steepest of points a quarter of a cell apart. Cost: O(area over cell²).
std::optional<std::string> landing_problem(const Terrain& terrain, const Vector2& centre,
                                           double radius);

}  // namespace skein::world
