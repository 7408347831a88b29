// SPDX-License-Identifier: Apache-2.0
// Plans from files as the planner's own.
#include "skein/htn/term_map.hpp"
#include "skein/htn_tools/given_plan.hpp"

namespace skein::htn {

namespace {

/// Terms with their floats in one precision: that of the numbers in a file cannot be seen.
class Precision {
 public:
  Precision(bool single_precision, TermStore& store) : single_(single_precision), store_(store) {}

  Term operator()(Term term) const {
    if (!single_) return term;
    return map_leaves(store_, term, kHasLooseEqual, [this](Term leaf) {
      return leaf.is(TermKind::kNumber) ? store_.number((*this)(store_.value(leaf))) : leaf;
    });
  }
  Number operator()(const Number& number) const {
    if (!single_ || number.kind != NumberKind::kDouble) return number;
    return single(number.real);
  }

 private:
  bool single_;
  TermStore& store_;
};

}  // namespace

Plan to_plan(const GivenPlan& given, bool single_precision, TermStore& store) {
  const Precision precise(single_precision, store);
  Plan plan;
  plan.cost = integer(0);
  for (const GivenStep& step : given.steps) {
    const Term action = precise(step.action);
    const Number cost = precise(step.cost.value_or(integer(1)));
    const Term name = action.is(TermKind::kPair) ? store.car(action) : action;
    const bool internal = name.is(TermKind::kSymbol) && store.name(name).starts_with("!!");
    plan.steps.push_back({action, cost, internal});
    plan.cost = add(plan.cost, cost).value_or(plan.cost);
  }
  for (const GivenNode& node : given.tree) {
    TreeNode made;
    made.kind = node.kind;
    made.children = node.children;
    made.task = precise(node.task);
    made.immediate = node.immediate;
    made.method = node.method;
    made.step = node.step;
    for (const CausalLink& link : node.support) {
      made.support.push_back({precise(link.fact), link.step});
    }
    plan.tree.push_back(std::move(made));
  }
  for (TreeIndex at = 0; at < plan.tree.size(); ++at) {
    for (const TreeIndex child : plan.tree[at].children) {
      if (child < plan.tree.size()) plan.tree[child].parent = at;
    }
  }
  return plan;
}

}  // namespace skein::htn
