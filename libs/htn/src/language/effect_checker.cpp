// SPDX-License-Identifier: Apache-2.0
#include "language/effect_checker.hpp"

#include "language/typed_list.hpp"

namespace skein::htn {

void EffectChecker::check_list(Expression list) {
  if (!list || context_.is_nil(list)) return;
  open_.push_back(list);
  while (!open_.empty()) {
    const Expression at = open_.back();
    open_.pop_back();
    if (context_.is_nil(at)) continue;
    if (context_.is_variable(at)) {
      anything_ = true;
    } else if (context_.head(at) != kNil && !context_.is_variable(first(at))) {
      context_.warn(at, "one atom where a list of atoms belongs", "((atom) …)");
      check_element(at);
    } else if (context_.is_list(at)) {
      for (Expression element = first(at); element; element = next(element)) check_element(element);
    } else {
      context_.error(at, text_of(at) + " is no list of atoms", "((predicate arguments…) …)");
    }
  }
}

void EffectChecker::check_element(Expression element) {
  if (context_.is_nil(element)) return;
  if (context_.is_variable(element)) {
    anything_ = true;
    return;
  }
  const Words& words = context_.words;
  const Term word = context_.head(element);
  if (word == words.forall || word == words.shop_forall) return check_forall(element);
  if (word == words.protection) {
    const Expression atom = next(first(element));
    const bool one = atom && !next(atom);
    if (!one || (!context_.is_list(atom) && !context_.is_variable(atom))) {
      context_.error(element, "a protection of no atom", "(:protection (predicate arguments…))");
    }
    return;
  }
  take_atom(element);
}

void EffectChecker::take_atom(Expression atom) {
  const Expression begin = first(atom);
  if (!begin || !context_.is_symbol(begin) || context_.is_nil(begin)) {
    return context_.error(atom, text_of(atom) + " is no atom", "(predicate arguments…)");
  }
  if (context_.is_variable(begin)) {
    anything_ = true;
  } else {
    atoms_.push_back(atom);
  }
}

// (forall (variables…) condition atoms): the atoms are checked with the rest that is open.
void EffectChecker::check_forall(Expression element) {
  const std::vector<Expression> all = parts(element);
  if (all.size() != 4 || (*element).dotted) {
    return context_.error(element, "a forall of " + counted(all.size() - 1, "part"),
                          "(forall (variables…) condition (atoms…))");
  }
  read_typed_list(context_, all[1], TypedNames::kVariables);
  conditions_.check(all[2]);
  open_.push_back(all[3]);
}

void EffectChecker::check_effect(Expression effect) {
  if (!effect) return;
  open_.push_back(effect);
  while (!open_.empty()) {
    const Expression at = open_.back();
    open_.pop_back();
    check_one_effect(at);
  }
}

void EffectChecker::check_one_effect(Expression effect) {
  if (context_.is_nil(effect)) return;
  const Words& words = context_.words;
  const Term word = context_.head(effect);
  const std::vector<Expression> all = parts(effect);
  if (!all.empty() && context_.is_list(all.front())) {
    open_.insert(open_.end(), all.rbegin(), all.rend());
  } else if (word == words.conjunction) {
    open_.insert(open_.end(), all.rbegin(), all.rend() - 1);
  } else if (word == words.negation) {
    if (all.size() != 2 || context_.head(all[1]) == kNil) {
      context_.error(effect, text_of(effect) + " is no effect", "(not (predicate arguments…))");
    }
  } else if (word == words.when || word == words.forall) {
    check_quantified(effect);
  } else if (word == words.increase || word == words.decrease || word == words.assign ||
             word == words.scale_up || word == words.scale_down) {
    if (all.size() == 3) return;
    context_.error(effect, context_.name(word) + " with " + counted(all.size() - 1, "argument"),
                   "(" + context_.name(word) + " fluent amount)");
  } else {
    take_atom(effect);
  }
}

void EffectChecker::check_quantified(Expression effect) {
  const std::vector<Expression> all = parts(effect);
  const bool when = context_.head(effect) == context_.words.when;
  if (all.size() != 3) {
    return context_.error(effect, text_of(effect) + " has not two parts",
                          when ? "(when condition effect)" : "(forall (variables…) effect)");
  }
  if (when) {
    conditions_.check(all[1]);
  } else {
    read_typed_list(context_, all[1], TypedNames::kVariables);
  }
  open_.push_back(all[2]);
}

void check_conditions_and_effects(const DomainDefinition& domain, ConditionChecker& conditions,
                                  EffectChecker& effects) {
  for (const OperatorDefinition& made : domain.operators) {
    conditions.check_precondition(made.precondition);
    effects.check_list(made.deletions);
    effects.check_list(made.additions);
    effects.check_effect(made.effect);
  }
  for (const MethodDefinition& made : domain.methods) {
    for (const BranchDefinition& branch : made.branches) {
      conditions.check_precondition(branch.precondition);
    }
  }
  for (const AxiomDefinition& made : domain.axioms) {
    for (const BranchDefinition& tail : made.tails)
      conditions.check_precondition(tail.precondition);
  }
}

}  // namespace skein::htn
