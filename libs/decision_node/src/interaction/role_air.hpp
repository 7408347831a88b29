// SPDX-License-Identifier: Apache-2.0
// Closed air ahead of a flight of a role.
#pragma once

#include <vector>

#include "skein/functional/parameters.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/vehicle_state.hpp"
#include "skein/world/volume.hpp"

namespace skein::decision_node {

/// The first volume, closed now or within half a minute, that the rest of a goto enters before it
/// is open again; the goto began at `from` [m, ENU]. Null: none, or the vehicle is inside one and
/// has to leave it. Cost: O(way-points × volumes).
const world::Volume* closed_ahead(const functional::Parameters& flight, const world::Vector3& from,
                                  const world::VehicleState& state,
                                  const world::VehicleModel& model,
                                  const std::vector<world::Volume>& volumes, MissionTime now);

}  // namespace skein::decision_node
