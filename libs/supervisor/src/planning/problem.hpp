// SPDX-License-Identifier: Apache-2.0
// A situation and high-level tasks as a problem of the planner.
#pragma once

#include "skein/htn/domain.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// In terms of the store, in the form of the seeds: what the domain asks of the initial state
/// (docs/comets-domain.md), and the tasks in their order. Times are seconds since the origin.
htn::Problem problem_of(const PlanningRequest& request, htn::TermStore& store);

}  // namespace skein::supervisor
