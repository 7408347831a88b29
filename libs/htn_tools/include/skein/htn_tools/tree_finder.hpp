// SPDX-License-Identifier: Apache-2.0
// Finds the decomposition for a plan that is given without a tree.
#pragma once

#include "skein/htn/planner.hpp"
#include "skein/htn_tools/given_plan.hpp"

namespace skein::htn {

/// Looks for a decomposition of the problem's tasks that yields exactly the plan's steps, by the
/// planner's search that takes no other step. Verdict: kPlan, with the decomposition (and the steps
/// with the precision of their numbers) in `plan`; kNoPlan: no decomposition yields these steps, so
/// they do not accomplish the tasks; kLimit, kError: nothing is known, and `why` says why. That a
/// tree is one is for the Validator to say, who shares no code with the search. Cost: as planning,
/// where each choice that leads to another step ends at once.
struct FoundTree {
  Verdict verdict = Verdict::kNoPlan;
  std::string why;
  GivenPlan plan;
};
FoundTree find_tree(const Domain& domain, const Problem& problem, const GivenPlan& given,
                    const Limits& limits, const Host& host = {});

}  // namespace skein::htn
