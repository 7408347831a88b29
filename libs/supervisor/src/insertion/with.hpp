// SPDX-License-Identifier: Apache-2.0
// Operators 1 and 6 with a replaceable planner, for tests.
#pragma once

#include "insertion/judge.hpp"
#include "skein/supervisor/repair.hpp"

namespace skein::supervisor {

InsertionOutcome insert_tasks(const InsertionRequest& request, const Planner& planner);
RepairOutcome repair_plan(const RepairRequest& request, const Planner& planner);

}  // namespace skein::supervisor
