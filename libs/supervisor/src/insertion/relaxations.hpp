// SPDX-License-Identifier: Apache-2.0
// What bounds of time would have to be for an order that cannot keep them.
#pragma once

#include <vector>

#include "insertion/judge.hpp"

namespace skein::supervisor {

/// The latest dates of high-level tasks that would serve: the plan of that order without bounds
/// from above, durations as short as they may be, gives those in mission time; its network then the
/// least that each bound after a goal must allow, in their order. In whole seconds, and tried:
/// empty unless the order with these bounds can be planned and kept to. No bound that can be kept
/// is named. Cost: two plans, and some twenty checks of the network for each bound after a goal.
std::vector<Relaxation> relaxations_for(const Judge& judge, const Goals& order);

}  // namespace skein::supervisor
