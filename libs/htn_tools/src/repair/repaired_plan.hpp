// SPDX-License-Identifier: Apache-2.0
// Puts a repaired plan together and compares it with the old one.
#pragma once

#include <vector>

#include "repair/old_tree.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::htn {

/// The tree of the whole plan: what is done or in progress from the old tree, with the trees that
/// `made` has for the remaining tasks in their places.
std::vector<TreeNode> merged_tree(const Plan& old, const OldTree& tree,
                                  const RemainingTasks& remaining, const Plan& made,
                                  StepIndex executed);

/// The topmost tasks that `made` accomplishes by another branch or other subtasks; those in
/// `again` in any case.
std::vector<Redone> redone_tasks(const Plan& old, const OldTree& tree,
                                 const RemainingTasks& remaining, const Plan& made,
                                 const std::vector<TreeIndex>& again, TermStore& store);

/// Fills kept, added and dropped: behind the executed ones steps of equal action go together in
/// their order.
void compare_steps(const Plan& old, StepIndex executed, TermStore& store, Repair& repair);

/// The term with its unbound variables numbered by where they stand: what two searches left
/// unbound has different names.
Term renumbered(Term term, TermStore& store);

}  // namespace skein::htn
