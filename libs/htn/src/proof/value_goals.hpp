// SPDX-License-Identifier: Apache-2.0
// Goals of expressions that are met as values of variables.
#pragma once

#include <optional>
#include <string>

#include "compile/compiled_domain.hpp"
#include "proof/bindings.hpp"
#include "proof/budget.hpp"

namespace skein::htn {

/// Compiles each expression once, into the domain. What is no condition ends the search.
class ValueGoals {
 public:
  ValueGoals(CompiledDomain& domain, Bindings& bindings, Budget& budget)
      : domain_(domain), store_(domain.store), bindings_(bindings), budget_(budget) {}

  /// An atom, (and …), (or …), (not …), (imply …) or a list of these; `from` has the variable.
  std::optional<GoalIndex> goal_of(Term term, const Goal& from);
  std::optional<ConditionIndex> condition_of_atom(Term atom);

 private:
  std::optional<ConditionIndex> condition_of_terms(Term list, const Goal& from);
  void fail(const Goal& goal, const std::string& why);

  static constexpr int kDeepestValue = 200;

  CompiledDomain& domain_;
  TermStore& store_;
  Bindings& bindings_;
  Budget& budget_;
  int nesting_ = 0;
};

}  // namespace skein::htn
