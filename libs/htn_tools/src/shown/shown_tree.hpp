// SPDX-License-Identifier: Apache-2.0
// The nodes of a decomposition that are worth showing: networks that say nothing are passed
// through.
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
  /// Where showing begins: the root, or what stands for it.
  std::vector<TreeIndex> top() const;
  /// Shown nodes right below a shown one, in order.
  std::vector<TreeIndex> below(TreeIndex index) const;
  /// What a node needed that a step had made, each fact once.
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
