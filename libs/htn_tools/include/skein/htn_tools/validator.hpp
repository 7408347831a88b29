// SPDX-License-Identifier: Apache-2.0
// Plan validation: replays the steps against domain and problem, independently of the planner.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn/functions.hpp"
#include "skein/htn/number.hpp"
#include "skein/htn_tools/given_plan.hpp"

namespace skein::htn {

/// Why a plan is refused.
enum class FaultKind : std::uint8_t {
  kUnknownOperator,
  kArity,            ///< the operator takes another number of arguments
  kPrecondition,     ///< a conjunct has no proof
  kEffect,           ///< protection violated, or an effect that is not ground
  kCost,             ///< the file gives another cost
  kEvaluation,       ///< a term cannot be evaluated, or a proof is too long
  kTasks,            ///< the steps apply, but do not accomplish the tasks of the problem
  kInternalLeftOut,  ///< the plan lacks its internal steps: nothing can be said
  kTree              ///< the tree is no decomposition that yields the steps
};

struct Fault {
  FaultKind kind = FaultKind::kPrecondition;
  std::size_t step = 0;  ///< position of the first step that does not apply; for kTree of a node
  int line = 0;          ///< of the plan file, 0 if unknown
  std::string why;       ///< a sentence
};

struct Validation {
  std::optional<Fault> fault;  ///< absent: the plan is valid
  Number cost;                 ///< of all steps, if they apply
  std::size_t steps = 0;       ///< that applied
  bool tree_checked = false;
};

/// Where a precondition has several proofs with different effects the plan is valid if some
/// choice lets all steps apply. Not used by the planner and not using it, so that each can test
/// the other. Without a tree nothing is said on whether the steps come from the problem's tasks.
/// Thread rule: one thread at a time.
class Validator {
 public:
  struct Limits {
    std::uint64_t inferences = 200'000'000;  ///< goals tried in one validation
    std::size_t retries = 2'000;             ///< other choices tried
  };

  /// Unknown functions and the like go to `errors`. Definitions and store must outlive the
  /// validator.
  Validator(const DomainDefinition& domain, const std::vector<FunctionDefinition>& functions,
            const Functions& host, TermStore& store, Diagnostics& errors);
  ~Validator();

  Validation validate(const ProblemDefinition& problem, const GivenPlan& plan,
                      const Limits& limits) const;
  Validation validate(const ProblemDefinition& problem, const GivenPlan& plan) const {
    return validate(problem, plan, Limits{});
  }

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// "valid: 12 steps, cost 7.5", or "step 3 (line 4): precondition unmet: (on a b)".
std::string to_text(const Validation& validation);

}  // namespace skein::htn
