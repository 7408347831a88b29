// SPDX-License-Identifier: Apache-2.0
// Whether what an operator or action changes is well formed, and which atoms it may add.
#pragma once

#include <vector>

#include "language/condition_checker.hpp"
#include "language/read_context.hpp"

namespace skein::htn {

class EffectChecker {
 public:
  explicit EffectChecker(const ReadContext& context) : context_(context), conditions_(context) {}

  /// The delete or add list of an operator: atoms, variables, (forall …), (:protection atom).
  void check_list(Expression list);
  /// The :effect of a PDDL action.
  void check_effect(Expression effect);

  /// The atoms met as changes: protections and negative effects left out.
  const std::vector<Expression>& atoms() const { return atoms_; }
  /// The atoms of the conditions of forall and when.
  const std::vector<Expression>& condition_atoms() const { return conditions_.atoms(); }
  /// A variable stands for atoms: anything may be changed.
  bool anything() const { return anything_; }

 private:
  void check_element(Expression element);
  void check_forall(Expression element);
  void check_one_effect(Expression effect);
  void check_quantified(Expression effect);
  void take_atom(Expression atom);

  const ReadContext& context_;
  ConditionChecker conditions_;
  std::vector<Expression> open_;
  std::vector<Expression> atoms_;
  bool anything_ = false;
};

/// All conditions of a domain's operators, methods and axioms, and all that its operators change.
void check_conditions_and_effects(const DomainDefinition& domain, ConditionChecker& conditions,
                                  EffectChecker& effects);

}  // namespace skein::htn
