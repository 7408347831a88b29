// SPDX-License-Identifier: Apache-2.0
// Elementary tasks that operators gave to a UAV, one by one.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "skein/laws/history.hpp"

namespace skein::laws {

/// Those of the scenario's script; whether the UAV took them or not.
std::set<std::int64_t> given_by_hand(const History& history, const Uav& uav);

/// What the vehicle did of them, but for takeshots, which ride along with something else. A plan
/// waits behind it.
std::vector<const Activity*> carried_out_by_hand(const History& history, const Uav& uav);

/// The vehicle does one of these at that instant [s].
bool does_by_hand(const History& history, const Uav& uav, double at);
/// It was an operator who last moved it before that instant [s].
bool was_left_by_hand(const History& history, const Uav& uav, double at);

}  // namespace skein::laws
