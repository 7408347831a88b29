// SPDX-License-Identifier: Apache-2.0
// Where a vehicle may land: one rule for vehicles and planners.
#pragma once

#include <optional>
#include <string>

#include "skein/world/terrain.hpp"

namespace skein::world {

/// No vehicle lands on ground that slopes by more [rad].
inline constexpr double kSteepestLanding = 0.2;

/// Why no vehicle can land at this point (outside the terrain, too steep); nothing if one can.
/// Cost: O(1).
std::optional<std::string> landing_problem(const Terrain& terrain, const Vector2& at);

/// The same for all points within `radius` [m] of `centre`, for vehicles with a touchdown error;
/// samples the slope a quarter of a cell apart, but at most half the radius and at least 1 m.
/// Cost: O(area / cell²).
std::optional<std::string> landing_problem(const Terrain& terrain, const Vector2& centre,
                                           double radius);

}  // namespace skein::world
