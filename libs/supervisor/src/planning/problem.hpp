// SPDX-License-Identifier: Apache-2.0
// The planner's problem from a situation and high-level tasks.
#pragma once

#include "skein/htn/domain.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// The problem in terms of `store`, in the form of the seeds: the initial state that the domain
/// asks for (docs/comets-domain.md), and the tasks in order. Times are seconds since the origin.
htn::Problem problem_of(const PlanningRequest& request, htn::TermStore& store);

}  // namespace skein::supervisor
