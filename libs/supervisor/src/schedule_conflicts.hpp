// SPDX-License-Identifier: Apache-2.0
// What breaks the network of a plan, in sentences about its tasks.
#pragma once

#include <vector>

#include "network.hpp"
#include "schedule_dates.hpp"
#include "skein/temporal/stnu_controllability.hpp"

namespace skein::supervisor {

/// Of a network that is not controllable. `foreseen` may be null; it gives the figures.
std::vector<Conflict> explain(const PlanNetwork& plan, const temporal::DcResult& verdict,
                              const NodeDates* foreseen);

}  // namespace skein::supervisor
