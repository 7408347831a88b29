// SPDX-License-Identifier: Apache-2.0
// Which conditions are of logic alone: no values of Lisp, no collections, no axiom that leads back
// to itself.
#include <algorithm>

#include "compiled_domain.hpp"

namespace skein::htn {

namespace {

class LogicalConditions {
 public:
  explicit LogicalConditions(CompiledDomain& domain) : domain_(domain) {}

  void mark() {
    for (Goal& one : domain_.goals) one.logical = goal(one);
    for (Condition& condition : domain_.conditions) {
      condition.logical = !condition.sorted && goals(condition.goals);
    }
  }

 private:
  bool goals(const std::vector<GoalIndex>& indexes) {
    return std::all_of(indexes.begin(), indexes.end(),
                       [this](GoalIndex index) { return goal(domain_.goals[index]); });
  }

  bool goal(const Goal& goal) {
    switch (goal.kind) {
      case GoalKind::kAtom:
        return goal.axioms == nullptr || axioms(goal.predicate, *goal.axioms);
      case GoalKind::kAnd:
      case GoalKind::kOr:
      case GoalKind::kNot:
      case GoalKind::kImply:
      case GoalKind::kForall:
      case GoalKind::kExists:
        return std::all_of(
            goal.conditions.begin(), goal.conditions.end(),
            [this](ConditionIndex index) { return goals(domain_.conditions[index].goals); });
      default:
        return false;
    }
  }

  // While the axioms of a predicate are looked into they count as not logical: that is what one
  // that leads back to itself finds.
  bool axioms(Term predicate, const std::vector<Axiom>& of) {
    const auto [known, fresh] = predicates_.try_emplace(predicate, false);
    if (!fresh || nesting_ == kDeepest) return known->second;
    ++nesting_;
    const bool logical = std::all_of(of.begin(), of.end(), [this](const Axiom& axiom) {
      return std::all_of(axiom.tails.begin(), axiom.tails.end(),
                         [this](const AxiomTail& tail) { return goals(tail.goals); });
    });
    --nesting_;
    predicates_[predicate] = logical;
    return logical;
  }

  static constexpr int kDeepest = 20;
  CompiledDomain& domain_;
  std::unordered_map<Term, bool> predicates_;
  int nesting_ = 0;
};

}  // namespace

void mark_logical(CompiledDomain& domain) { LogicalConditions(domain).mark(); }

}  // namespace skein::htn
