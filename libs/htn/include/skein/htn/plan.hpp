// SPDX-License-Identifier: Apache-2.0
// Plans as values: steps with costs, the decomposition they come from, and what supports what.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/htn/number.hpp"
#include "skein/htn/term.hpp"

namespace skein::htn {

/// A place in a plan: position in `Plan::steps`, or one of the values below.
using StepIndex = std::uint32_t;
inline constexpr StepIndex kInitialState = 0xFFFFFFFFU;  ///< held from the start
inline constexpr StepIndex kNoStep = 0xFFFFFFFEU;
inline constexpr StepIndex kOutside = 0xFFFFFFFDU;  ///< came about during execution, by no step

/// Position in `Plan::tree`.
using TreeIndex = std::uint32_t;
inline constexpr TreeIndex kNoParent = 0xFFFFFFFFU;

/// One application of an operator.
struct Step {
  Term action;    ///< (!name argument…)
  Number cost;    ///< as the operator's cost expression gave it
  bool internal;  ///< `!!name`: book-keeping of the domain
  bool operator==(const Step&) const = default;
};

/// `fact` made a precondition true; `step` had produced it.
struct CausalLink {
  Term fact;  ///< an atom, or (not atom)
  StepIndex step = kInitialState;
  bool operator==(const CausalLink&) const = default;
};

enum class TreeNodeKind : std::uint8_t { kOrdered, kUnordered, kTask, kStep };

/// A node of the decomposition: a task and the method that reduced it, the task network of that
/// reduction, or a step.
struct TreeNode {
  TreeNodeKind kind = TreeNodeKind::kTask;
  TreeIndex parent = kNoParent;
  std::vector<TreeIndex> children;  ///< in the order of the domain's text
  Term task;                        ///< for tasks and steps, with all that is known bound
  bool immediate = false;
  std::string method;               ///< label of the branch that reduced the task
  StepIndex step = kNoStep;         ///< for kStep
  std::vector<CausalLink> support;  ///< what the precondition of the branch or operator needed
};

/// What one step made of the state, in the order of its effects: only what was not so before.
struct StateChange {
  std::vector<Term> deleted;
  std::vector<Term> added;
};

/// A solution. The order of `steps` is the order of execution.
struct Plan {
  std::vector<Step> steps;
  Number cost;                       ///< the sum over all steps
  std::vector<TreeNode> tree;        ///< node 0 is the root; empty unless trees were asked for
  std::vector<StateChange> changes;  ///< of each step; empty unless states were asked for
};

}  // namespace skein::htn
