// SPDX-License-Identifier: Apache-2.0
// Terms from text, and a small plan with a tree, made by hand.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "skein/htn/plan.hpp"
#include "skein/htn/syntax.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn::testing_plans {

inline Term term_of(const Document& document, NodeIndex index, TermStore& store) {
  if (!document[index].list) return document[index].atom;
  std::vector<Term> items;
  for (const NodeIndex child : children(document, index)) {
    items.push_back(term_of(document, child, store));
  }
  if (!document[index].dotted) return store.list(items);
  const Term tail = items.back();
  items.pop_back();
  return store.list(items, tail);
}

inline Term term(const std::string& text, TermStore& store) {
  Diagnostics errors;
  const Document document = read_document("term", text, store, errors);
  EXPECT_TRUE(errors.empty()) << to_text(errors);
  return document.top.empty() ? kNil : term_of(document, document.top.front(), store);
}

/// Steps and nodes one after the other; a node's children follow it and name it as parent.
class PlanBuilder {
 public:
  explicit PlanBuilder(TermStore& store) : store_(store) { plan_.cost = integer(0); }

  PlanBuilder& step(const std::string& action, Number cost) {
    const Term made = term(action, store_);
    plan_.steps.push_back({made, cost, store_.name(store_.car(made)).starts_with("!!")});
    plan_.cost = *add(plan_.cost, cost);
    return *this;
  }
  TreeIndex network(TreeNodeKind kind, TreeIndex parent = kNoParent) {
    TreeNode node;
    node.kind = kind;
    return put(node, parent);
  }
  TreeIndex task(const std::string& task, const std::string& method, TreeIndex parent) {
    TreeNode node;
    node.task = term(task, store_);
    node.method = method;
    return put(node, parent);
  }
  TreeIndex leaf(StepIndex step, TreeIndex parent) {
    TreeNode node;
    node.kind = TreeNodeKind::kStep;
    node.step = step;
    node.task = plan_.steps[step].action;
    return put(node, parent);
  }
  void needs(TreeIndex node, const std::string& fact, StepIndex from) {
    plan_.tree[node].support.push_back({term(fact, store_), from});
  }
  TreeNode& operator[](TreeIndex node) { return plan_.tree[node]; }
  const Plan& plan() const { return plan_; }

 private:
  TreeIndex put(TreeNode node, TreeIndex parent) {
    const auto index = static_cast<TreeIndex>(plan_.tree.size());
    node.parent = parent;
    plan_.tree.push_back(std::move(node));
    if (parent != kNoParent) plan_.tree[parent].children.push_back(index);
    return index;
  }

  TermStore& store_;
  Plan plan_;
};

/// One task, reduced to three steps the second of which is internal; the third needs the first.
inline Plan swap_plan(TermStore& store) {
  PlanBuilder builder(store);
  builder.step("(!drop banjo)", integer(1));
  builder.step("(!!note banjo)", integer(0));
  builder.step("(!pickup kiwi)", single(2.5));
  const TreeIndex root = builder.network(TreeNodeKind::kOrdered);
  const TreeIndex swap = builder.task("(swap banjo kiwi)", "has-first", root);
  builder.needs(swap, "(have banjo)", kInitialState);
  const TreeIndex body = builder.network(TreeNodeKind::kOrdered, swap);
  builder.leaf(0, body);
  builder.leaf(1, body);
  const TreeIndex last = builder.leaf(2, body);
  builder.needs(last, "(free hand)", 0);
  builder.needs(last, "(noted banjo)", 1);
  return builder.plan();
}

}  // namespace skein::htn::testing_plans
