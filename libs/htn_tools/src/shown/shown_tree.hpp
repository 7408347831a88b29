// SPDX-License-Identifier: Apache-2.0
// The nodes of a decomposition for display; networks without information are skipped.
#pragma once

#include <string>
#include <vector>

#include "shown/step_numbers.hpp"
#include "skein/htn/plan.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

class ShownTree {
 public:
  ShownTree(const Plan& plan, bool internal) : plan_(plan), numbers_(plan, internal) {}

  const StepNumbers& numbers() const { return numbers_; }
  const TreeNode& operator[](TreeIndex index) const { return plan_.tree[index]; }
  /// The topmost shown nodes: the root, or its shown descendants.
  std::vector<TreeIndex> top() const;
  /// Shown nodes right below a shown one, in order.
  std::vector<TreeIndex> below(TreeIndex index) const;
  /// The facts that a node needed and a step had made, without duplicates.
  std::vector<CausalLink> made(TreeIndex index) const;
  /// Name of the operator of a step: "!drive". Empty for a plan that has no such step.
  std::string operator_of(StepIndex step, const TermStore& store) const;

 private:
  bool hidden(const TreeNode& node) const;
  bool transparent(TreeIndex index) const;
  std::vector<TreeIndex> expand(std::vector<TreeIndex> open) const;

  const Plan& plan_;
  StepNumbers numbers_;
};

}  // namespace skein::htn
