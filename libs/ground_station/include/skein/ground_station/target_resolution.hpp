// SPDX-License-Identifier: Apache-2.0
// Where a scripted task goes, once it is known.
#pragma once

#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/ground_orders/script.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground_station {

/// The points [m, ENU] of a target, at least one. Fails with the reason when it is about the alarm
/// and there is none (`subject` null), when the pattern is empty, or on figures that are not
/// finite.
Result<std::vector<world::Vector3>, Failure> resolve(const Target& target, const Alarm* subject,
                                                     const world::Terrain& terrain);

}  // namespace skein::ground_station
