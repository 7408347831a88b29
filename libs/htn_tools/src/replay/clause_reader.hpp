// SPDX-License-Identifier: Apache-2.0
// Reads the expressions of one clause for the validator.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "replay/clauses.hpp"

namespace skein::htn::replay {

/// Reads the expressions of one clause; variables are numbered in the order they are met.
class ClauseReader {
 public:
  ClauseReader(TermStore& store, Lisp& lisp, Diagnostics& errors)
      : store_(store), lisp_(lisp), errors_(errors) {}

  std::uint32_t slots() const { return next_slot_; }
  Term pattern(Expression expression, int depth = 0);
  Condition condition(Expression expression);
  std::vector<Goal> sequence(Expression expression, int depth = 0);
  NetworkClause network(Expression expression, int depth = 0);
  std::vector<Effect> effects(Expression list, EffectKind kind, int depth = 0);
  Effect pddl_effect(Expression expression, int depth = 0);
  std::vector<Goal> type_goals(Expression typed, bool enforced, std::vector<Term>* names);
  CodeIndex code(Expression expression) {
    return lisp_.compile(expression, slot_lookup(), errors_);
  }

 private:
  static std::vector<Expression> parts(Expression list);
  bool is_symbol(Expression expression, std::string_view name) const;
  static bool is_nil(Expression expression);
  static bool is_list(Expression expression) { return is_nil(expression) || (*expression).list; }
  bool is_variable(Expression expression) const {
    return expression && !(*expression).list && variable_name((*expression).atom);
  }
  bool variable_name(Term atom) const {
    return atom.is(TermKind::kSymbol) && store_.name(atom).starts_with('?');
  }
  Term slot_for(Term name) {
    if (store_.name(name).starts_with("?_")) return {TermKind::kSlot, next_slot_++};
    const auto [at, fresh] = slot_of_.try_emplace(name.bits(), next_slot_);
    if (fresh) ++next_slot_;
    return {TermKind::kSlot, at->second};
  }
  SlotOf slot_lookup() {
    return [this](Term name) -> std::optional<std::uint32_t> { return slot_for(name).index(); };
  }
  bool too_deep(Expression expression, int depth);
  Goal element(Expression expression, int depth);
  Goal goal(Expression expression, int depth);
  Goal quantified(GoalKind kind, const std::vector<Expression>& items, int depth);
  Goal evaluated(const std::vector<Expression>& items, Expression whole);
  Goal plain(GoalKind kind, const std::vector<Expression>& items, int depth);
  bool contains_call(Expression expression, int depth = 0) const;
  NetworkClause task(Expression expression);

  TermStore& store_;
  Lisp& lisp_;
  Diagnostics& errors_;
  std::map<std::uint32_t, std::uint32_t> slot_of_;
  std::uint32_t next_slot_ = 0;
};

}  // namespace skein::htn::replay
