// SPDX-License-Identifier: Apache-2.0
// Why a search failed: what stood in the way where it came furthest.
#include <algorithm>

#include "search.hpp"
#include "term_map.hpp"

namespace skein::htn {

namespace {
constexpr std::size_t kMostNearest = 3;
}

void Search::dead_end(NodeId node, Term task) {
  const std::uint64_t expansion = budget_->expansions();
  if (explain_at_) {
    if (explain_at_->expansion == expansion && !failure_) {
      explain(node, task);
      budget_->stop("explained");
    }
    return;
  }
  const bool further =
      steps_.size() > deepest_failure_.steps ||
      (steps_.size() == deepest_failure_.steps && depth_ >= deepest_failure_.depth);
  if (further) deepest_failure_ = {expansion, steps_.size(), depth_};
}

FailurePoint Search::point_at(NodeId node) {
  FailurePoint point;
  for (const StepRecord& step : steps_) {
    const Term name = store_.car(step.action);
    if (store_.name(name) == "!!inop") continue;
    point.steps.push_back({step.action, step.cost, internal(store_, name)});
  }
  for (NodeId at = node; at != kNoNodeId; at = agenda_[at].parent) {
    if (agenda_[at].kind == NetworkKind::kTask) {
      point.open_tasks.push_back(bindings_.instance(agenda_[at].task, 0));
    }
  }
  std::reverse(point.open_tasks.begin(), point.open_tasks.end());
  return point;
}

std::optional<FailurePoint> Search::standing() {
  if (cut_) return cut_;
  if (agenda_.empty()) return {};
  const NodeId immediate = agenda_.first_immediate();
  return point_at(immediate != kNoNodeId ? immediate : agenda_.first());
}

void Search::explain(NodeId node, Term task) {
  failure_ = point_at(node);
  explain_task(task);
}

// Every operator or branch that might have done it, with the condition that stopped it.
void Search::explain_task(Term task) {
  const Term name = store_.car(task);
  const Bindings::Mark mark = bindings_.mark();
  const auto operation = domain_.operators.find(name);
  if (operation != domain_.operators.end()) {
    const Base base = bindings_.open(operation->second.slots);
    Attempt attempt{task, std::string(store_.name(name)), "", {}};
    if (!bindings_.unify(store_.cdr(operation->second.head), base, store_.cdr(task), 0)) {
      attempt.condition = "the task does not match " + store_.to_text(operation->second.head);
      failure_->attempts.push_back(attempt);
    } else if (steps_made_->precondition_failed()) {
      explain_condition(operation->second.precondition, {operation->second, base}, attempt);
    } else {
      attempt.condition = steps_made_->why();
      failure_->attempts.push_back(attempt);
    }
    bindings_.undo(mark);
  }
  const auto methods = domain_.methods.find(name);
  if (methods == domain_.methods.end()) {
    if (operation == domain_.operators.end()) {
      failure_->attempts.push_back({task, "", "no method or operator has this name", {}});
    }
    return;
  }
  for (const Method& method : methods->second) {
    const Base base = bindings_.open(method.slots);
    if (bindings_.unify(store_.cdr(method.head), base, store_.cdr(task), 0)) {
      for (const Branch& branch : method.branches) {
        explain_condition(branch.precondition, {method, base}, {task, branch.label, "", {}});
      }
    }
    bindings_.undo(mark);
  }
}

void Search::explain_condition(ConditionIndex condition, const Activation& activation,
                               Attempt attempt) {
  if (first_unmet(condition, activation, attempt)) failure_->attempts.push_back(std::move(attempt));
}

// The first conjunct that fails whatever satisfies those before it, under the first such satisfier.
bool Search::first_unmet(ConditionIndex condition, const Activation& activation, Attempt& attempt) {
  const Base base = activation.base;
  if (condition == kAbsent) return false;
  const std::vector<GoalIndex> goals = domain_.conditions[condition].goals;
  Answers before;
  for (std::size_t count = 1; count <= goals.size(); ++count) {
    Answers answers;
    if (!prover_->solve_part(condition, count, base, answers)) return false;
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

// For traces, which count no inferences of their own.
std::string Search::unmet_text(ConditionIndex condition, const Activation& activation) {
  const std::uint64_t inferences = budget_->inferences();
  Attempt attempt;
  const bool known = first_unmet(condition, activation, attempt);
  budget_->take_back(budget_->inferences() - inferences);
  return known && !attempt.condition.empty() ? "needs " + attempt.condition : std::string();
}

std::string Search::step_unmet_text(const Operator& operation, Term task) {
  const Bindings::Mark mark = bindings_.mark();
  const Base base = bindings_.open(operation.slots);
  std::string text;
  if (bindings_.unify(store_.cdr(operation.head), base, store_.cdr(task), 0)) {
    text = unmet_text(operation.precondition, {operation, base});
  }
  bindings_.undo(mark);
  return text.empty() ? text : ": it " + text;
}

// "?x = a, ?y = b; ?x = c, ?y = d; …": what the first satisfiers give the variables of the text.
std::string Search::values_text(const Clause& clause, Base base, const Answers& answers) {
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
Term Search::readable(Term pattern, const Activation& activation) {
  const Clause& clause = activation.clause;
  return map_leaves(store_, bindings_.instance(pattern, activation.base), kHasVariable,
                    [&](Term variable) {
                      const std::uint32_t slot = variable.index() - activation.base;
                      const bool own = variable.index() >= activation.base && slot < clause.slots;
                      return own ? clause.names[slot] : variable;
                    });
}

// Facts of the goal's predicate that agree with it in the most arguments.
std::vector<Term> Search::nearest_facts(const Goal& goal, Base base) {
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
