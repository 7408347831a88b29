// SPDX-License-Identifier: Apache-2.0
// Which conditions are of logic alone, with no values of Lisp and no collections, and which of
// these meet no axiom that leads back to itself.
#include <algorithm>

#include "compile/compiled_domain.hpp"

namespace skein::htn {

namespace {

class LogicalConditions {
 public:
  explicit LogicalConditions(CompiledDomain& domain) : domain_(domain) {}

  void mark() {
    for (const auto& [name, axioms] : domain_.axioms) numbers_.emplace(name, numbers_.size());
    predicates_.resize(numbers_.size());
    for (const auto& [name, axioms] : domain_.axioms) look_at(axioms, numbers_.at(name));
    spread_values();
    spread_ends();
    for (Goal& goal : domain_.goals) {
      goal.logical = logical(goal);
      goal.finite = goal.logical && finite(goal);
    }
    for (Condition& condition : domain_.conditions) {
      condition.logical = of_all(condition, &LogicalConditions::logical);
      condition.finite = condition.logical && of_all(condition, &LogicalConditions::finite);
    }
  }

 private:
  struct Predicate {
    std::vector<std::size_t> users;  // whose axioms ask for it, as often as they do
    std::size_t unknown = 0;         // how many it asks for of which the end is not known
    bool logical = true;
    bool finite = false;
  };
  using Test = bool (LogicalConditions::*)(const Goal&) const;

  void look_at(const std::vector<Axiom>& axioms, std::size_t number) {
    for (const Axiom& axiom : axioms) {
      for (const AxiomTail& tail : axiom.tails) look_at(tail.goals, number);
    }
  }
  void look_at(const std::vector<GoalIndex>& goals, std::size_t number) {
    for (const GoalIndex index : goals) {
      const Goal& goal = domain_.goals[index];
      predicates_[number].logical = predicates_[number].logical && connects(goal.kind);
      if (goal.axioms != nullptr) {
        predicates_[numbers_.at(goal.predicate)].users.push_back(number);
        ++predicates_[number].unknown;
      }
      for (const ConditionIndex inner : goal.conditions) {
        look_at(domain_.conditions[inner].goals, number);
      }
    }
  }

  // What asks for something that is not of logic alone is not either.
  void spread_values() {
    std::vector<std::size_t> found;
    for (std::size_t at = 0; at < predicates_.size(); ++at) {
      if (!predicates_[at].logical) found.push_back(at);
    }
    while (!found.empty()) {
      const std::size_t at = found.back();
      found.pop_back();
      for (const std::size_t user : predicates_[at].users) {
        if (std::exchange(predicates_[user].logical, false)) found.push_back(user);
      }
    }
  }

  // What asks only for what ends does so too; what leads back to itself is never reached.
  void spread_ends() {
    std::vector<std::size_t> found;
    for (std::size_t at = 0; at < predicates_.size(); ++at) {
      if (predicates_[at].unknown == 0) found.push_back(at);
    }
    while (!found.empty()) {
      const std::size_t at = found.back();
      found.pop_back();
      predicates_[at].finite = true;
      for (const std::size_t user : predicates_[at].users) {
        if (--predicates_[user].unknown == 0) found.push_back(user);
      }
    }
  }

  static bool connects(GoalKind kind) {
    return kind == GoalKind::kAtom || kind == GoalKind::kAnd || kind == GoalKind::kOr ||
           kind == GoalKind::kNot || kind == GoalKind::kImply || kind == GoalKind::kForall ||
           kind == GoalKind::kExists;
  }
  bool logical(const Goal& goal) const {
    if (goal.axioms != nullptr) return predicates_[numbers_.at(goal.predicate)].logical;
    return connects(goal.kind) && inside(goal, &LogicalConditions::logical);
  }
  bool finite(const Goal& goal) const {
    if (goal.axioms != nullptr) return predicates_[numbers_.at(goal.predicate)].finite;
    return inside(goal, &LogicalConditions::finite);
  }
  bool inside(const Goal& goal, Test test) const {
    return std::all_of(goal.conditions.begin(), goal.conditions.end(), [&](ConditionIndex index) {
      return of_all(domain_.conditions[index], test);
    });
  }
  bool of_all(const Condition& condition, Test test) const {
    return std::all_of(condition.goals.begin(), condition.goals.end(),
                       [&](GoalIndex index) { return (this->*test)(domain_.goals[index]); });
  }

  CompiledDomain& domain_;
  std::unordered_map<Term, std::size_t> numbers_;  // of predicates that axioms tell of
  std::vector<Predicate> predicates_;
};

}  // namespace

void mark_logical(CompiledDomain& domain) { LogicalConditions(domain).mark(); }

}  // namespace skein::htn
