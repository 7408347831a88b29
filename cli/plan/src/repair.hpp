// SPDX-License-Identifier: Apache-2.0
// `skein plan --repair`: a plan under execution after the world has changed.
#pragma once

#include <vector>

#include "library.hpp"
#include "skein/plan_tool/plan.hpp"
#include "validate.hpp"

namespace skein::plan_tool {

/// Repairs the one plan of options.repair.
int repair_plan(Library& library, const std::vector<ChosenProblem>& problems,
                const PlanOptions& options, const Surroundings& surroundings,
                const Streams& streams);

}  // namespace skein::plan_tool
