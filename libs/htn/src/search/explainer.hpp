// SPDX-License-Identifier: Apache-2.0
// Explanations why a task could not be accomplished.
#pragma once

#include <string>
#include <vector>

#include "proof/prover.hpp"
#include "search/step_maker.hpp"
#include "skein/htn/planner.hpp"

namespace skein::htn {

/// A clause and the cells of its variables.
struct Activation {
  const Clause& clause;
  Base base;
};

/// Evaluates conditions in the current state; restores all bindings before a call returns.
/// Lifetime: refers to its arguments.
class Explainer {
 public:
  Explainer(CompiledDomain& domain, Bindings& bindings, FactBase& facts, Prover& prover,
            Budget& budget)
      : domain_(domain),
        store_(domain.store),
        bindings_(bindings),
        facts_(facts),
        prover_(prover),
        budget_(budget) {}

  /// Every operator or branch for the task, with the condition that failed. Precondition: `maker`
  /// has just tried the operator.
  std::vector<Attempt> attempts(Term task, const StepMaker& maker);
  /// "needs …", or nothing. For traces: counts no inferences of its own.
  std::string unmet_text(ConditionIndex condition, const Activation& activation);
  std::string step_unmet_text(const Operator& operation, Term task);
  /// "?x = a, ?y = b; ?x = c, ?y = d; …": values of the clause's variables in the first satisfiers.
  std::string values_text(const Clause& clause, Base base, const Answers& answers);

 private:
  void try_operator(const Operator& operation, Term task, const StepMaker& maker,
                    std::vector<Attempt>& attempts);
  bool first_unmet(ConditionIndex condition, const Activation& activation, Attempt& attempt);
  Term readable(Term pattern, const Activation& activation);
  std::vector<Term> nearest_facts(const Goal& goal, Base base);

  CompiledDomain& domain_;
  TermStore& store_;
  Bindings& bindings_;
  FactBase& facts_;
  Prover& prover_;
  Budget& budget_;
};

}  // namespace skein::htn
