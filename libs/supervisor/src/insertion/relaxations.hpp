// SPDX-License-Identifier: Apache-2.0
// The bounds on time with which an infeasible order would be feasible.
#pragma once

#include <vector>

#include "insertion/judge.hpp"

namespace skein::supervisor {

/// The least relaxations of upper bounds that make `order` feasible; bounds that can be kept are
/// not listed. Absolute bounds follow from the plan of the order without upper bounds and with
/// least durations; then each bound after a goal, in order, is set to the least that the network
/// allows. In whole seconds, and verified: empty unless the order with the relaxed bounds is
/// feasible. Cost: two plans, and some twenty checks of the network for each bound after a goal.
std::vector<Relaxation> relaxations_for(const Judge& judge, const Goals& order);

}  // namespace skein::supervisor
