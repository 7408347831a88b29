// SPDX-License-Identifier: Apache-2.0
// From logical expressions as written to goals and conditions.
#pragma once

#include <tsl/robin_map.h>

#include <optional>
#include <string>
#include <vector>

#include "compile/compiled_domain.hpp"
#include "compile/expression_term.hpp"

namespace skein::htn {

/// The variables of a clause by name. `?_` and `?_name` are a new variable each time; the variables
/// of a quantifier hide those of the same name outside.
class ClauseScope {
 public:
  explicit ClauseScope(TermStore& store) : store_(store) {}
  std::uint32_t slot(Term variable);
  /// The variables of a quantifier: one, or a list that may have types in it.
  void hide(Expression variables);
  void reveal();
  SlotOf slot_of();
  void finish(Clause& clause) const;

 private:
  std::uint32_t fresh(Term variable);
  TermStore& store_;
  using Slots = tsl::robin_map<Term, std::uint32_t>;
  Slots slots_;
  std::vector<Slots> hidden_;
  std::vector<Term> names_;
};

bool is_variable(const TermStore& store, Term term);

class ConditionCompiler {
 public:
  ConditionCompiler(CompiledDomain& domain, Diagnostics& errors)
      : domain_(domain), errors_(errors) {}

  /// Any text as a term, its variables as slots of the scope. Works without recursion.
  Term pattern(Expression expression, ClauseScope& scope);
  /// A precondition: a conjunction, one goal, nothing, or one of these with :first or :sort-by.
  ConditionIndex condition(Expression expression, ClauseScope& scope);
  /// A precondition of a PDDL action: with the types of its parameters.
  ConditionIndex typed_condition(Expression typed_list, Expression expression, ClauseScope& scope);
  /// The goals of an axiom's tail.
  AxiomTail tail(const BranchDefinition& definition, ClauseScope& scope);
  /// Goals for `(type ?v)` of a typed list, `object` and (either …) apart; the variables go to
  /// `variables`. What is no variable, as the name of a head, is passed over.
  std::optional<GoalIndex> type_goal(Expression type, std::uint32_t variable);
  std::vector<GoalIndex> type_goals(Expression typed_list, ClauseScope& scope,
                                    std::vector<Term>& variables);
  /// A PDDL effect on a number: (increase (name …) term) and the like; empty if it is none.
  std::optional<Effect> fluent_effect(Expression expression, ClauseScope& scope);
  ConditionIndex add_condition(std::vector<GoalIndex> goals, Expression where);
  CodeIndex code(Expression expression, ClauseScope& scope);

  void error(Expression where, std::string message, std::string expected = "");
  Diagnostics& errors() { return errors_; }

 private:
  std::vector<GoalIndex> conjunction(Expression expression, ClauseScope& scope);
  void append_goals(Expression expression, ClauseScope& scope, std::vector<GoalIndex>& out);
  std::vector<GoalIndex> rest_goals(Expression list, std::size_t skip, ClauseScope& scope);
  GoalIndex goal(Expression expression, ClauseScope& scope);
  GoalIndex atom(Expression expression, ClauseScope& scope);
  bool names_fluent(Expression expression) const;
  bool compares_fluents(Expression expression, std::string_view name) const;
  GoalIndex fluent_comparison(Expression expression, ClauseScope& scope);
  Term fluent_value(Expression fluent, ClauseScope& scope, std::vector<GoalIndex>& goals);
  std::string render(Expression expression, ClauseScope& scope, std::vector<GoalIndex>& goals);
  CodeIndex made_code(std::string text, Expression where, ClauseScope& scope);
  GoalIndex connective(GoalKind kind, Expression expression, ClauseScope& scope);
  GoalIndex alternatives(Expression expression, ClauseScope& scope);
  GoalIndex implication(Expression expression, ClauseScope& scope);
  GoalIndex quantified(GoalKind kind, Expression expression, ClauseScope& scope);
  GoalIndex typed_quantified(GoalKind kind, Expression expression, ClauseScope& scope);
  GoalIndex evaluation(Expression expression, ClauseScope& scope, bool call);
  GoalIndex assignment(GoalKind kind, Expression expression, ClauseScope& scope);
  GoalIndex collection(GoalKind kind, Expression expression, ClauseScope& scope);
  GoalIndex enforcement(Expression expression, ClauseScope& scope);
  GoalIndex add(Goal goal) {
    domain_.goals.push_back(std::move(goal));
    return static_cast<GoalIndex>(domain_.goals.size() - 1);
  }
  void sort_by(Expression expression, ClauseScope& scope, Condition& condition);

  CompiledDomain& domain_;
  Diagnostics& errors_;
  TermScratch scratch_;
  int nesting_ = 0;
  int made_variables_ = 0;
};

/// The goal of an atom pattern with the positions where its values may be known.
Goal atom_goal(const TermStore& store, Term pattern, Expression where);
/// Slots that occur in the goals, quantified parts apart: what a satisfier gives values to.
void set_slots(const CompiledDomain& domain, Condition& condition);

/// Children of a list expression.
std::vector<Expression> parts(Expression list);

}  // namespace skein::htn
