// SPDX-License-Identifier: Apache-2.0
// Resolves the targets of scripted tasks to points.
#pragma once

#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/ground_orders/script.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground_station {

/// The points [m, ENU] of a target, at least one. Failures: the target refers to the alarm and
/// there is none (`subject` null), its pattern is empty, or figures are not finite.
Result<std::vector<world::Vector3>, Failure> resolve(const Target& target, const Alarm* subject,
                                                     const world::Terrain& terrain);

}  // namespace skein::ground_station
