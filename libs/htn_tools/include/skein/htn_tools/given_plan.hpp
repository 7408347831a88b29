// SPDX-License-Identifier: Apache-2.0
// Plans that come from outside, as files give them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/plan.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

struct GivenStep {
  Term action;                 ///< (!name argument…)
  std::optional<Number> cost;  ///< where the file gives one
  int line = 0;                ///< of the file
};

/// A node of a decomposition tree; indices are positions in GivenPlan::tree, node 0 is the root.
struct GivenNode {
  TreeNodeKind kind = TreeNodeKind::kTask;
  std::vector<TreeIndex> children;
  Term task;
  std::string method;  ///< label of the branch
  StepIndex step = kNoStep;
  bool immediate = false;
  std::vector<CausalLink> support{};  ///< as in the plan; what an internal step made is left out
};

struct GivenPlan {
  std::string problem;         ///< empty where the file does not say
  std::optional<Number> cost;  ///< of all steps
  std::vector<GivenStep> steps;
  std::vector<GivenNode> tree;    ///< empty: none given
  bool without_internal = false;  ///< the file says that steps `!!name` are left out
};

/// Reads what `skein plan --json` writes (one object a line; spec 3.2) or the text form, one step
/// a line: `(!name argument…) [cost]`, `;` starts a comment. An object that reports no plan gives
/// none. Precision of floats cannot be seen in either form: they are read as double precision.
std::vector<GivenPlan> read_plans(const std::string& file, const std::string& text,
                                  TermStore& store, Diagnostics& errors);

/// The plan as the planner makes it, with its tree if one is given. With `single_precision` all
/// floats become single precision.
Plan to_plan(const GivenPlan& given, bool single_precision, TermStore& store);

}  // namespace skein::htn
