// SPDX-License-Identifier: Apache-2.0
// Tasks that must start while another runs: earliest starts alone do not always see to that.
#pragma once

#include <vector>

#include "network.hpp"
#include "schedule_dates.hpp"

namespace skein::supervisor {

/// Tasks that may not start while the task they run beside does, or before what stops them, since
/// they wait for something that may come later. Empty: for a controllable network, starting each
/// task as early as it may be is a strategy that succeeds.
std::vector<Conflict> late_companions(const PlanNetwork& plan, const NodeDates& allowed,
                                      const NodeDates& foreseen, MissionTime now);

}  // namespace skein::supervisor
