// SPDX-License-Identifier: Apache-2.0
// Who goes first through air that several want.
#pragma once

#include <optional>
#include <string>

#include "merging/portions.hpp"
#include "merging/vehicle_air.hpp"
#include "merging/waiting.hpp"
#include "skein/merging/merger.hpp"
#include "skein/supervisor/schedule.hpp"

namespace skein::decision_node {

/// For the dates of plans: for whom `waiting` waits, and who waits for what this UAV flies. A sweep
/// is one motion, which has begun once a portion of it is flown. Pure.
supervisor::AirOrders air_orders(const std::string& uav, const std::optional<Waiting>& waiting,
                                 const std::optional<Portions>& portions, const VehicleAir& vehicle,
                                 const merging::Merger& merger);

}  // namespace skein::decision_node
