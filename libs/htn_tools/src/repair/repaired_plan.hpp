// SPDX-License-Identifier: Apache-2.0
// Puts a repaired plan together and compares it with the old one.
#pragma once

#include <vector>

#include "repair/old_tree.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::htn {

/// The tree of the whole plan: the tasks done or in progress from the old tree, with the trees of
/// `made` in place of the remaining tasks.
std::vector<TreeNode> merged_tree(const Plan& old, const OldTree& tree,
                                  const RemainingTasks& remaining, const Plan& made,
                                  StepIndex executed);

/// The topmost tasks that `made` accomplishes by another branch or other subtasks, and all tasks in
/// `again`.
std::vector<Redone> redone_tasks(const Plan& old, const OldTree& tree,
                                 const RemainingTasks& remaining, const Plan& made,
                                 const std::vector<TreeIndex>& again, TermStore& store);

/// Fills kept, added and dropped: after the executed steps, steps of equal action are matched in
/// order.
void compare_steps(const Plan& old, StepIndex executed, TermStore& store, Repair& repair);

/// The term with its unbound variables numbered by position, so that results of different searches
/// are comparable.
Term renumbered(Term term, TermStore& store);

}  // namespace skein::htn
