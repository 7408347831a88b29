// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/tree_finder.hpp"

#include <algorithm>
#include <cmath>

namespace skein::htn {

namespace {

// Files do not say of which precision a float is.
bool same_number(const Number& left, const Number& right) {
  const double one = to_double(left);
  const double other = to_double(right);
  return one == other || std::abs(one - other) <= 2e-6 * std::max(std::abs(one), std::abs(other));
}

// What the planner left unbound may be anything.
bool agrees(const TermStore& store, Term given, Term made) {
  while (given.is(TermKind::kPair) && made.is(TermKind::kPair)) {
    if (!agrees(store, store.car(given), store.car(made))) return false;
    given = store.cdr(given);
    made = store.cdr(made);
  }
  if (given.is(TermKind::kLocal) || given == made) return true;
  return given.is(TermKind::kNumber) && made.is(TermKind::kNumber) &&
         same_number(store.value(given), store.value(made));
}

GivenPlan with_tree(const GivenPlan& given, const Plan& plan) {
  GivenPlan out = given;
  for (std::size_t at = 0; at < out.steps.size(); ++at)
    out.steps[at].action = plan.steps[at].action;
  for (const TreeNode& node : plan.tree) {
    out.tree.push_back({node.kind, node.children, node.task, node.method, node.step, node.immediate,
                        node.support});
  }
  return out;
}

}  // namespace

FoundTree find_tree(const Domain& domain, const Problem& problem, const GivenPlan& given,
                    const Limits& limits, const Host& host) {
  const TermStore& store = domain.store();
  Options options;
  options.limits = limits;
  options.trees = true;
  options.following = {given.steps.size(), [&](std::size_t step, Term action) {
                         return agrees(store, given.steps[step].action, action);
                       }};
  Outcome outcome = plan(domain, problem, options, host);
  FoundTree found{outcome.verdict, outcome.why, given};
  if (!outcome.plans.empty()) found.plan = with_tree(given, outcome.plans.front());
  return found;
}

}  // namespace skein::htn
