// SPDX-License-Identifier: Apache-2.0
// Repairs a plan under execution after the world has changed by itself.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/htn/planner.hpp"

namespace skein::htn {

/// An exogenous change of a fact during execution.
struct Change {
  bool added = false;  ///< else deleted
  Term fact;           ///< ground
  bool operator==(const Change&) const = default;
};

/// The changes noticed after the first `after` steps of the plan were executed.
struct Divergence {
  StepIndex after = 0;
  std::vector<Change> changes;  ///< in their order
};

struct RepairRequest {
  /// With its tree and causal links (Options::trees): as the planner, or an earlier repair, made
  /// it.
  const Plan* plan = nullptr;
  StepIndex executed = 0;  ///< steps of the plan that were executed; never undone
  /// In the order of time. Those of earlier repairs belong here too: without them the executed
  /// steps may not be applicable.
  std::vector<Divergence> divergences;
};

struct RepairOptions {
  Limits limits;             ///< of all searches together
  std::size_t compared = 3;  ///< plans: the one that keeps most steps is taken, then the first
};

enum class RepairVerdict : std::uint8_t {
  kStands,    ///< the rest of the plan can be executed as it is, and its methods still apply
  kRepaired,  ///< `plan` is a new one
  kNoPlan,    ///< what remains of the tasks cannot be accomplished from here
  kLimit,     ///< cut by a limit or cancelled before any plan was found
  kError      ///< request or plan does not fit the problem, or a term could not be evaluated
};

/// A task that is accomplished otherwise than in the old plan.
struct Redone {
  Term task;
  bool begun =
      false;  ///< some of its steps were executed; it is begun again from the present state
  bool operator==(const Redone&) const = default;
};

/// The first needed fact that the divergence made false.
struct Clobbered {
  Term fact;  ///< (not atom) if the atom came about
  Term task;  ///< the task or step that needs it
};

struct Repair {
  RepairVerdict verdict = RepairVerdict::kError;
  std::string why;  ///< which limit, or what is wrong
  /// The executed steps, unchanged, and after them the new ones; numbers, costs and links as if all
  /// were one plan. Executed steps whose task is begun again hang in an ordered network beside the
  /// old root, both below a new unordered root. Absent without a plan.
  Plan plan;
  std::vector<StepIndex> kept;     ///< of the new plan behind the executed ones: were in the old
  std::vector<StepIndex> added;    ///< of the new plan: were not
  std::vector<StepIndex> dropped;  ///< of the old plan: not executed, not in the new
  std::vector<Redone> redone;      ///< topmost, in the order of the old plan
  std::optional<Clobbered> clobbered;  ///< by the causal links
  std::size_t attempts = 0;            ///< ways of repairing that were searched
  Statistics statistics;               ///< of all searches together
};

/// Tries, from the smallest repair on: the present decomposition with the tasks that have not
/// begun decomposed anew where they must be; then the task in progress around the step that
/// cannot be done any more begun again, then the task above it, up to all tasks of the problem
/// that are not finished. In each the old plan's choices and order come first. Tasks that are
/// finished stay so. Protections stay in force. Deterministic.
/// Source: docs/decisions/0007-plan-repair.md.
Repair repair(const Domain& domain, const Problem& problem, const RepairRequest& request,
              const RepairOptions& options = {}, const Host& host = {});

}  // namespace skein::htn
