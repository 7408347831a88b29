// SPDX-License-Identifier: Apache-2.0
// The decomposition of a plan as a Graphviz graph.
#pragma once

#include <string>

#include "skein/htn/plan.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

struct PlanGraphOptions {
  bool internal = true;  ///< show steps `!!name`
  std::string title;     ///< above the drawing; may be empty
};

/// A `digraph` for `dot`: tasks as rounded boxes with the branch that reduced them, steps as filled
/// boxes numbered in the order of execution and drawn in it, causal links dashed from the step that
/// made the fact to the task or step that needed it. Cost: linear.
std::string to_dot(const Plan& plan, const TermStore& store, const PlanGraphOptions& options);

}  // namespace skein::htn
