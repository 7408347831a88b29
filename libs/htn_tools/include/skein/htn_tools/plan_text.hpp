// SPDX-License-Identifier: Apache-2.0
// Plans for people: numbered steps, and the decomposition as an indented tree.
#pragma once

#include <string>

#include "skein/htn/plan.hpp"
#include "skein/htn/term_store.hpp"
#include "skein/htn_tools/text_style.hpp"

namespace skein::htn {

struct PlanTextOptions {
  bool internal = true;  ///< show steps `!!name`; without them the others are numbered anew
  TextStyle style = kPlainText;
  bool states = false;  ///< below each step what it changed
};

/// One step a line, numbered from 1, its cost at the right. Cost: linear.
std::string steps_text(const Plan& plan, const TermStore& store, const PlanTextOptions& options);

/// The decomposition, one node a line: tasks with the branch that reduced them, steps with their
/// number and cost, `← (fact) from 3 (!drive …)` for each fact a node needed that a step had made.
/// Ordered networks show as their children alone. Guides are drawn for the innermost 40 levels; how
/// many are left out is said in brackets. Empty for a plan without tree. Cost: linear; no
/// recursion.
std::string tree_text(const Plan& plan, const TermStore& store, const PlanTextOptions& options);

}  // namespace skein::htn
