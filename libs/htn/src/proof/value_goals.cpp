// SPDX-License-Identifier: Apache-2.0
#include "proof/value_goals.hpp"

#include <algorithm>
#include <array>

#include "compile/condition_compiler.hpp"
#include "proof/evaluator.hpp"

namespace skein::htn {

namespace {

bool connective(std::string_view name) {
  constexpr std::array kNames{"imply",   "forall", "exists", "eval",    "call",   "assign",
                              "assign*", "setof",  "bagof",  "enforce", ":first", ":sort-by"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

}  // namespace

std::optional<ConditionIndex> ValueGoals::condition_of_atom(Term atom) {
  const auto known = domain_.conditions_of_atoms.find(atom);
  if (known != domain_.conditions_of_atoms.end()) return known->second;
  const std::optional<ConditionIndex> made = condition_of_terms(store_.pair(atom, kNil), Goal{});
  if (made) domain_.conditions_of_atoms.emplace(atom, *made);
  return made;
}

std::optional<GoalIndex> ValueGoals::goal_of(Term term, const Goal& from) {
  const auto known = domain_.goals_of_terms.find(term);
  if (known != domain_.goals_of_terms.end()) return known->second;
  Goal made;
  if (!term.is(TermKind::kPair)) {
    fail(from, store_.to_text(term) + " is no condition");
    return std::nullopt;
  }
  const Term head = store_.car(term);
  const std::string_view name = head.is(TermKind::kSymbol) ? store_.name(head) : std::string_view{};
  const bool group = head.is(TermKind::kPair);
  if (name == "and" || group || name == "not") {
    made.kind = name == "not" ? GoalKind::kNot : GoalKind::kAnd;
    const auto inner = condition_of_terms(group ? term : store_.cdr(term), from);
    if (!inner) return std::nullopt;
    made.conditions = {*inner};
  } else if (name == "or") {
    made.kind = GoalKind::kOr;
    for (const Term part : store_.items(store_.cdr(term))) {
      const auto inner = condition_of_terms(store_.pair(part, kNil), from);
      if (!inner) return std::nullopt;
      made.conditions.push_back(*inner);
    }
  } else if (!head.is(TermKind::kSymbol) || connective(name)) {
    fail(from, "a value cannot be the condition " + store_.to_text(term));
    return std::nullopt;
  } else {
    made = atom_goal(store_, term, from.where);
  }
  made.where = from.where;
  link_axioms(domain_, made);
  domain_.goals.push_back(std::move(made));
  const auto index = static_cast<GoalIndex>(domain_.goals.size() - 1);
  domain_.goals_of_terms.emplace(term, index);
  return index;
}

std::optional<ConditionIndex> ValueGoals::condition_of_terms(Term list, const Goal& from) {
  if (++nesting_ > kDeepestValue) {
    fail(from, "a value is nested too deeply to be a condition");
    return std::nullopt;
  }
  Condition condition;
  for (const Term part : store_.items(list)) {
    const std::optional<GoalIndex> goal = goal_of(part, from);
    if (!goal) return std::nullopt;
    condition.goals.push_back(*goal);
    bindings_.collect_unbound(part, 0, condition.variables);
  }
  --nesting_;
  domain_.conditions.push_back(std::move(condition));
  return static_cast<ConditionIndex>(domain_.conditions.size() - 1);
}

void ValueGoals::fail(const Goal& goal, const std::string& why) {
  budget_.fail(place_text(goal.where) + ": " + why);
}

}  // namespace skein::htn
