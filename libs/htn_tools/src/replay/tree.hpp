// SPDX-License-Identifier: Apache-2.0
// Checks that a tree is a decomposition of the problem's tasks that yields the steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replay/operator.hpp"
#include "skein/htn_tools/given_plan.hpp"

namespace skein::htn::replay {

struct TreeFault {
  TreeIndex node = 0;
  std::string why;
};

/// Checks the shape, the order of steps that the networks allow, that each task is reduced by the
/// method named, and that the method's precondition held, and those of its earlier branches did
/// not, in some state between the end of what comes before and the first step below. `world` is
/// the initial state; `done` says what each step does.
std::optional<TreeFault> check_tree(ProofContext& context, World& world, const NetworkClause& tasks,
                                    std::uint32_t task_slots, const GivenPlan& plan,
                                    const std::vector<Application>& done);

}  // namespace skein::htn::replay
