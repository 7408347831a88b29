// SPDX-License-Identifier: Apache-2.0
// The planner: ordered task decomposition, depth first, in the order of SHOP2.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/htn/domain.hpp"
#include "skein/htn/plan.hpp"

namespace skein::htn {

/// Which plans are wanted.
enum class Which : std::uint8_t {
  kFirst,          ///< the first in search order
  kAll,            ///< every plan the search order meets; never one twice by the same choices
  kShallowest,     ///< a plan of least depth
  kAllShallowest,  ///< all plans of least depth
  kIdFirst,        ///< the first, by iterative deepening
  kIdAll,          ///< all, by iterative deepening, the shallow ones first
  kBest            ///< a plan of least cost, by branch and bound; costs may not be negative
};

/// Where a search gives up; absent: no limit. Each holds inside a single precondition too.
struct Limits {
  std::optional<double> seconds;  ///< of processor time, as Host::cpu_seconds gives it
  std::optional<std::uint64_t> expansions;
  std::optional<std::uint64_t> inferences;
  std::optional<std::uint64_t> depth;  ///< of decompositions and steps along one path
  std::optional<std::uint64_t> plans;
  std::optional<std::uint64_t> memory_bytes;  ///< of the search's own structures
};

/// What the search tells while it runs.
enum class TraceKind : std::uint8_t {
  kTask,         ///< a task is taken from the agenda
  kBranchFails,  ///< the precondition of a branch has no satisfier
  kBranchHolds,  ///< a branch is taken: `count` reductions
  kReduction,    ///< a reduction is tried
  kStep,         ///< an operator is applied
  kStepFails,    ///< an operator does not apply: `detail` says why
  kBacktrack     ///< all ways of a task are exhausted
};

struct TraceEvent {
  TraceKind kind = TraceKind::kTask;
  std::uint64_t depth = 0;
  Term task;
  std::string label;  ///< of the branch
  std::uint64_t count = 0;
  std::string detail;
};

/// What the search may ask of its host. Every function may be absent.
struct Host {
  std::function<double()> cpu_seconds;  ///< processor time so far [s]
  std::function<bool()> cancelled;      ///< asked every few thousand inferences; any thread may set
  std::function<void(const Plan&)> plan_found;  ///< each plan when it is found (anytime)
  std::function<void(const TraceEvent&)> trace;
};

/// How an earlier plan accomplished a task: tried first when the task comes again. The preferences
/// of a task that comes several times are used up in their order.
struct Preference {
  Term task;
  std::string method;          ///< label of the branch; empty for a step
  std::vector<Term> subtasks;  ///< as the branch gave them, or with more bound
  std::uint32_t order = 0;     ///< of several tasks that may be next the one with the least is
};

/// Only plans of so many steps, each of them agreed to; the step that empty tasks become
/// (`!!inop`) is none of them.
struct Following {
  std::size_t steps = 0;
  std::function<bool(std::size_t step, Term action)> agrees;
};

struct Options {
  Which which = Which::kFirst;
  bool optimize_cost = false;        ///< keep the plan of least cost (:optimize-cost t)
  std::optional<double> cost_limit;  ///< only plans up to this cost (:optimize-cost n)
  Limits limits;
  bool trees = false;                     ///< record decomposition and causal links
  std::vector<std::string> traced_tasks;  ///< names; empty: all, if the host listens
  std::vector<Preference> preferences;
  std::optional<Following> following;
  bool explain_failure = false;  ///< fill Outcome::failure and standing when there is no plan
  bool states = false;           ///< record what each step changes
};

/// A way that was tried where a search came furthest.
struct Attempt {
  Term task;                  ///< that could not be accomplished there
  std::string label;          ///< branch or operator
  std::string condition;      ///< the first conjunct that has no satisfier after those before it
  std::vector<Term> nearest;  ///< facts that differ least from that conjunct
};
/// A point a search reached: the furthest at which nothing was left to try, or where it was cut.
struct FailurePoint {
  std::vector<Step> steps;       ///< the partial plan
  std::vector<Term> open_tasks;  ///< from the top-level task down to the one that was to be done
  std::vector<Attempt> attempts{};
};

enum class Verdict : std::uint8_t {
  kPlan,    ///< at least one plan, the search ran its course
  kNoPlan,  ///< the whole search space holds none
  kLimit,   ///< cut by a limit or cancelled; `plans` holds the best so far
  kError    ///< a term could not be evaluated, a condition was enforced in vain
};

struct Statistics {
  std::uint64_t expansions = 0;  ///< tasks taken plus plans found (as SHOP3 counts)
  std::uint64_t inferences = 0;  ///< goals the prover tried
  std::uint64_t deepest = 0;
  std::uint64_t memory_bytes = 0;  ///< greatest, of the search's own structures
};

struct Outcome {
  Verdict verdict = Verdict::kNoPlan;
  std::string why;  ///< which limit, the error with its place, or the bound that left no plan
  std::vector<Plan> plans;
  Statistics statistics;
  std::optional<FailurePoint> failure;   ///< the furthest dead end, if there was one
  std::optional<FailurePoint> standing;  ///< where a limit cut the search
  /// Of tasks that may be done in any order and are equal only one is tried: so often another was
  /// left out, with plans that would only repeat those found.
  std::uint64_t repeats_left_out = 0;
  bool out_of_memory = false;  ///< the limit was that the system gives no more memory
};

/// Deterministic: the same input gives the same outcome, limits of time and cancelling apart.
Outcome plan(const Domain& domain, const Problem& problem, const Options& options,
             const Host& host = {});

}  // namespace skein::htn
