// SPDX-License-Identifier: Apache-2.0
// Elementary tasks that operators gave to a UAV, one by one.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "skein/laws/history.hpp"

namespace skein::laws {

/// Ids of the tasks that the scenario's script gives to the UAV, whether the UAV accepted them or
/// not.
std::set<std::int64_t> given_by_hand(const History& history, const Uav& uav);

/// The vehicle's activities of such tasks, except takeshots, which run along with other tasks. A
/// plan waits until they are over.
std::vector<const Activity*> carried_out_by_hand(const History& history, const Uav& uav);

/// Whether the vehicle carries out such a task at that instant [s].
bool does_by_hand(const History& history, const Uav& uav, double at);
/// Whether the vehicle's last motion before that instant [s] was such a task.
bool was_left_by_hand(const History& history, const Uav& uav, double at);

}  // namespace skein::laws
