// SPDX-License-Identifier: Apache-2.0
#include "search/explainer.hpp"

#include <algorithm>
#include <utility>

#include "skein/htn/term_map.hpp"

namespace skein::htn {

namespace {
constexpr std::size_t kMostNearest = 3;
}

std::vector<Attempt> Explainer::attempts(Term task, const StepMaker& maker) {
  std::vector<Attempt> result;
  const Term name = store_.car(task);
  const auto operation = domain_.operators.find(name);
  if (operation != domain_.operators.end()) try_operator(operation->second, task, maker, result);
  const auto methods = domain_.methods.find(name);
  if (methods == domain_.methods.end()) {
    if (operation == domain_.operators.end()) {
      result.push_back({task, "", "no method or operator has this name", {}});
    }
    return result;
  }
  for (const Method& method : methods->second) {
    const Bindings::Mark mark = bindings_.mark();
    const Base base = bindings_.open(method.slots);
    if (bindings_.unify(store_.cdr(method.head), base, store_.cdr(task), 0)) {
      for (const Branch& branch : method.branches) {
        Attempt attempt{task, branch.label, "", {}};
        if (first_unmet(branch.precondition, {method, base}, attempt)) {
          result.push_back(std::move(attempt));
        }
      }
    }
    bindings_.undo(mark);
  }
  return result;
}

void Explainer::try_operator(const Operator& operation, Term task, const StepMaker& maker,
                             std::vector<Attempt>& attempts) {
  const Bindings::Mark mark = bindings_.mark();
  const Base base = bindings_.open(operation.slots);
  Attempt attempt{task, std::string(store_.name(store_.car(task))), "", {}};
  bool known = true;
  if (!bindings_.unify(store_.cdr(operation.head), base, store_.cdr(task), 0)) {
    attempt.condition = "the task does not match " + store_.to_text(operation.head);
  } else if (maker.precondition_failed()) {
    known = first_unmet(operation.precondition, {operation, base}, attempt);
  } else {
    attempt.condition = maker.why();
  }
  if (known) attempts.push_back(std::move(attempt));
  bindings_.undo(mark);
}

// The first conjunct that fails whatever satisfies those before it, under the first such satisfier.
bool Explainer::first_unmet(ConditionIndex condition, const Activation& activation,
                            Attempt& attempt) {
  const Base base = activation.base;
  if (condition == kAbsent) return false;
  const std::vector<GoalIndex> goals = domain_.conditions[condition].goals;
  Answers before;
  for (std::size_t count = 1; count <= goals.size(); ++count) {
    Answers answers;
    if (!prover_.solve_part(condition, count, base, answers)) return false;
    if (answers.count() > 0) {
      std::swap(before, answers);
      continue;
    }
    const Bindings::Mark mark = bindings_.mark();
    if (before.count() > 0) before.apply(0, bindings_);
    const Goal& goal = domain_.goals[goals[count - 1]];
    if (goal.kind == GoalKind::kAtom) {
      attempt.condition = store_.to_text(readable(goal.pattern, activation));
      attempt.nearest = nearest_facts(goal, base);
    } else if (goal.where) {
      const Node& node = *goal.where;
      attempt.condition = goal.where.document->text.substr(node.begin, node.end - node.begin);
    }
    bindings_.undo(mark);
    return true;
  }
  return false;
}

std::string Explainer::unmet_text(ConditionIndex condition, const Activation& activation) {
  const std::uint64_t inferences = budget_.inferences();
  Attempt attempt;
  const bool known = first_unmet(condition, activation, attempt);
  budget_.take_back(budget_.inferences() - inferences);
  return known && !attempt.condition.empty() ? "needs " + attempt.condition : std::string();
}

std::string Explainer::step_unmet_text(const Operator& operation, Term task) {
  const Bindings::Mark mark = bindings_.mark();
  const Base base = bindings_.open(operation.slots);
  std::string text;
  if (bindings_.unify(store_.cdr(operation.head), base, store_.cdr(task), 0)) {
    text = unmet_text(operation.precondition, {operation, base});
  }
  bindings_.undo(mark);
  return text.empty() ? text : ": it " + text;
}

std::string Explainer::values_text(const Clause& clause, Base base, const Answers& answers) {
  std::string out;
  for (std::size_t row = 0; row < std::min(answers.count(), kMostNearest); ++row) {
    const Bindings::Mark mark = bindings_.mark();
    answers.apply(row, bindings_);
    std::string values;
    for (std::uint32_t slot = 0; slot < clause.slots; ++slot) {
      if (store_.name(clause.names[slot]).starts_with("?_")) continue;
      const Term value = bindings_.instance(Term(TermKind::kSlot, slot), base);
      if (value.is(TermKind::kVariable)) continue;
      values += (values.empty() ? "" : ", ") + std::string(store_.name(clause.names[slot])) +
                " = " + store_.to_text(value);
    }
    bindings_.undo(mark);
    out += (out.empty() ? "" : "; ") + values;
  }
  return answers.count() > kMostNearest ? out + "; …" : out;
}

// An instance whose unbound variables have the names of the text.
Term Explainer::readable(Term pattern, const Activation& activation) {
  const Clause& clause = activation.clause;
  return map_leaves(store_, bindings_.instance(pattern, activation.base), kHasVariable,
                    [&](Term variable) {
                      const std::uint32_t slot = variable.index() - activation.base;
                      const bool own = variable.index() >= activation.base && slot < clause.slots;
                      return own ? clause.names[slot] : variable;
                    });
}

// Facts of the goal's predicate that agree with it in the most arguments.
std::vector<Term> Explainer::nearest_facts(const Goal& goal, Base base) {
  std::vector<std::pair<std::size_t, Term>> ranked;
  for (FactBase::Cursor at = facts_.all(goal.predicate); at.fact != kNoFact; at = facts_.next(at)) {
    const std::span<const Term> values = facts_.arguments(at.fact);
    std::size_t differing = values.size() == goal.arguments.size() ? 0 : values.size() + 1;
    for (std::size_t arg = 0; arg < std::min(values.size(), goal.arguments.size()); ++arg) {
      const Term wanted = bindings_.instance(goal.arguments[arg], base);
      if (!wanted.is(TermKind::kVariable) && wanted != values[arg]) ++differing;
    }
    ranked.emplace_back(differing, facts_.atom(at.fact));
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& left, const auto& right) { return left.first < right.first; });
  std::vector<Term> nearest;
  for (std::size_t at = 0; at < std::min(ranked.size(), kMostNearest); ++at) {
    nearest.push_back(ranked[at].second);
  }
  return nearest;
}

}  // namespace skein::htn
