// SPDX-License-Identifier: Apache-2.0
// Which tasks a contact-loss policy interrupted.
#pragma once

#include <vector>

#include "skein/mission/autonomy.hpp"

namespace skein::decision_node {

/// The tasks of `before` that `after` has no more or as aborting, and those that end with one of
/// them: as tasks to be begun anew, which nobody carries out. Without what was aborting before, and
/// without tasks that are not the ground's (own tasks, those of roles). In the order of `before`.
/// Cost: O(n^2) in the number of tasks that are not over.
std::vector<mission::HeldTask> interrupted_since(const std::vector<mission::HeldTask>& before,
                                                 const std::vector<mission::HeldTask>& after);

}  // namespace skein::decision_node
