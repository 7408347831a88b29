// SPDX-License-Identifier: Apache-2.0
#include "repair/old_tree.hpp"

#include <algorithm>

#include "repair/tree_walk.hpp"
#include "skein/htn/term_map.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kDeepestNetwork = 400;

}  // namespace

OldTree::OldTree(const Plan& plan, StepIndex executed, TermStore& store)
    : plan_(plan), executed_(executed), store_(store) {
  if (plan.tree.empty()) {
    fault_ = "the plan has no decomposition tree";
  } else if (!check_shape()) {
    fault_ = "the plan's decomposition is no tree";
  } else if (!check_steps()) {
    fault_ = "the plan's decomposition does not have each step once";
  } else {
    measure();
  }
}

bool OldTree::check_shape() {
  std::vector<bool> seen(plan_.tree.size(), false);
  std::vector<TreeIndex> open{0};
  seen[0] = true;
  while (!open.empty()) {
    const TreeIndex at = open.back();
    open.pop_back();
    top_down_.push_back(at);
    const std::vector<TreeIndex>& children = plan_.tree[at].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      if (*child >= seen.size() || seen[*child] || plan_.tree[*child].parent != at) return false;
      seen[*child] = true;
      open.push_back(*child);
    }
  }
  return top_down_.size() == plan_.tree.size();
}

bool OldTree::check_steps() {
  leaves_.assign(plan_.steps.size(), kNoParent);
  for (const TreeIndex at : top_down_) {
    const TreeNode& node = plan_.tree[at];
    if (node.kind != TreeNodeKind::kStep) continue;
    if (node.step >= leaves_.size() || leaves_[node.step] != kNoParent) return false;
    leaves_[node.step] = at;
  }
  return std::find(leaves_.begin(), leaves_.end(), kNoParent) == leaves_.end();
}

void OldTree::measure() {
  first_.assign(plan_.tree.size(), kNoStep);
  last_.assign(plan_.tree.size(), 0);
  for (auto at = top_down_.rbegin(); at != top_down_.rend(); ++at) {
    const TreeNode& node = plan_.tree[*at];
    if (node.kind == TreeNodeKind::kStep) first_[*at] = last_[*at] = node.step;
    if (idle(*at) || node.parent == kNoParent) continue;
    first_[node.parent] = std::min(first_[node.parent], first_[*at]);
    last_[node.parent] = std::max(last_[node.parent], last_[*at]);
  }
  mark_reached();
  mark_passed();
}

// A task without steps shows by its place only whether the planner may have met it already.
void OldTree::mark_reached() {
  reached_.assign(plan_.tree.size(), false);
  reached_[0] = true;
  for (const TreeIndex at : top_down_) {
    const TreeNode& node = plan_.tree[at];
    if (!reached_[at]) continue;
    if (node.kind == TreeNodeKind::kTask && !idle(at) && !begun(at)) continue;
    for (const TreeIndex child : node.children) {
      reached_[child] = true;
      const bool finished = idle(child) || last_[child] < executed_;
      if (node.kind == TreeNodeKind::kOrdered && !finished) break;
    }
  }
}

void OldTree::mark_passed() {
  passed_.assign(plan_.tree.size(), false);
  for (const TreeIndex at : top_down_) {
    const TreeNode& node = plan_.tree[at];
    bool passed = passed_[at];
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
      passed_[*child] = passed;
      if (node.kind == TreeNodeKind::kOrdered && begun(*child)) passed = true;
    }
  }
}

void OldTree::settle(const Gone& gone, bool cautious) {
  phases_.assign(plan_.tree.size(), Phase::kDone);
  for (const TreeIndex at : top_down_) {
    const TreeNode& node = plan_.tree[at];
    const bool topmost =
        node.kind == TreeNodeKind::kTask && idle(at) && phases_[at] == Phase::kDone;
    if (!topmost || passed_[at]) continue;
    const bool again = !reached_[at] || cautious || lost_below(at, gone);
    if (again) settle_idle(at, Phase::kAhead);
  }
  for (auto at = top_down_.rbegin(); at != top_down_.rend(); ++at) {
    if (!idle(*at) || is_network(plan_.tree[*at])) phases_[*at] = phase_of(*at);
  }
}

void OldTree::settle_idle(TreeIndex node, Phase phase) {
  for (const TreeIndex at : below(node)) phases_[at] = phase;
}

OldTree::Phase OldTree::phase_of(TreeIndex at) const {
  const TreeNode& node = plan_.tree[at];
  if (!idle(at) && first_[at] >= executed_) return Phase::kAhead;
  const bool all = std::all_of(node.children.begin(), node.children.end(),
                               [this](TreeIndex child) { return done(child); });
  return all ? Phase::kDone : Phase::kInProgress;
}

std::vector<TreeIndex> OldTree::below(TreeIndex node) const {
  std::vector<TreeIndex> found;
  std::vector<TreeIndex> open{node};
  while (!open.empty()) {
    const TreeIndex at = open.back();
    open.pop_back();
    found.push_back(at);
    const std::vector<TreeIndex>& children = plan_.tree[at].children;
    open.insert(open.end(), children.rbegin(), children.rend());
  }
  return found;
}

// What a step still ahead produces will be there again.
bool OldTree::lost(const CausalLink& link, const Gone& gone) const {
  const bool past = link.step == kInitialState || link.step == kOutside || link.step < executed_;
  return past && gone(link.fact);
}

std::optional<Term> OldTree::lost_at(TreeIndex node, const Gone& gone) const {
  for (const CausalLink& link : plan_.tree[node].support) {
    if (lost(link, gone)) return link.fact;
  }
  return std::nullopt;
}

std::optional<std::pair<TreeIndex, Term>> OldTree::lost_below(TreeIndex node,
                                                              const Gone& gone) const {
  for (const TreeIndex at : below(node)) {
    if (const std::optional<Term> fact = lost_at(at, gone)) return std::pair{at, *fact};
  }
  return std::nullopt;
}

std::optional<std::pair<TreeIndex, Term>> OldTree::first_clobbered(const Gone& gone) const {
  for (const TreeIndex at : top_down_) {
    if (!idle(at) || !reached_[at] || passed_[at]) continue;
    if (const std::optional<Term> fact = lost_at(at, gone)) return std::pair{at, *fact};
  }
  for (StepIndex step = executed_; step < leaves_.size(); ++step) {
    std::vector<TreeIndex> chain{leaves_[step]};
    for (TreeIndex up = plan_.tree[chain.back()].parent; up != kNoParent && first_[up] == step;
         up = plan_.tree[up].parent) {
      chain.push_back(up);
    }
    for (auto at = chain.rbegin(); at != chain.rend(); ++at) {
      if (const std::optional<Term> fact = lost_at(*at, gone)) return std::pair{*at, *fact};
    }
  }
  return std::nullopt;
}

std::vector<TreeIndex> OldTree::begun_above(TreeIndex node) const {
  std::vector<TreeIndex> found;
  for (TreeIndex at = node; at != kNoParent; at = plan_.tree[at].parent) {
    if (plan_.tree[at].kind == TreeNodeKind::kTask && in_progress(at)) found.push_back(at);
  }
  return found;
}

std::vector<TreeIndex> OldTree::top_tasks() const { return topmost_tasks(plan_.tree, {0}); }

// Networks inside networks of their own kind are dissolved, so that the nesting of tasks in
// progress does not become a nesting of networks.
std::optional<RemainingTasks> OldTree::remaining(const std::vector<TreeIndex>& again) const {
  struct Open {
    TreeIndex node;
    TaskNetwork* into;
    std::size_t depth;
  };
  RemainingTasks out;
  std::vector<Open> open{{0, &out.network, 0}};
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    const TreeNode& node = plan_.tree[next.node];
    if (done(next.node)) continue;
    if (next.depth > kDeepestNetwork) return std::nullopt;
    const bool begun_again = std::find(again.begin(), again.end(), next.node) != again.end();
    const bool whole = node.kind == TreeNodeKind::kStep ||
                       (node.kind == TreeNodeKind::kTask && (ahead(next.node) || begun_again));
    if (whole) {
      TaskNetwork leaf;
      leaf.kind = NetworkKind::kTask;
      leaf.task = node.task;
      leaf.immediate = node.immediate;
      next.into->children.push_back(std::move(leaf));
      out.leaves.push_back(next.node);
      continue;
    }
    const auto remain = std::count_if(node.children.begin(), node.children.end(),
                                      [this](TreeIndex child) { return !done(child); });
    const NetworkKind kind =
        node.kind == TreeNodeKind::kUnordered ? NetworkKind::kUnordered : NetworkKind::kOrdered;
    TaskNetwork* into = next.into;
    std::size_t depth = next.depth;
    if (remain > 1 && kind != into->kind) {
      // The children of `into` are put one after the other, so it does not grow before this
      // network is complete.
      into->children.emplace_back().kind = kind;
      into = &into->children.back();
      ++depth;
    }
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
      open.push_back({*child, into, depth});
    }
  }
  return out;
}

// Twice the step and one more; a task without steps comes behind what made its condition true.
std::uint32_t OldTree::order_of(TreeIndex node) const {
  if (!idle(node)) return 2 * first_[node] + 1;
  std::uint32_t order = 0;
  for (const CausalLink& link : plan_.tree[node].support) {
    if (link.step < plan_.steps.size()) order = std::max(order, 2 * (link.step + 1));
  }
  return order;
}

std::vector<Preference> OldTree::preferences(const std::vector<TreeIndex>& nodes) const {
  std::vector<Preference> out;
  for (const TreeIndex top : nodes) {
    for (const TreeIndex at : below(top)) {
      const TreeNode& node = plan_.tree[at];
      if (is_network(node)) continue;
      Preference preference{node.task, node.method, {}, order_of(at)};
      if (node.kind == TreeNodeKind::kTask) {
        for (const TreeIndex part : subtask_nodes(plan_.tree, at)) {
          preference.subtasks.push_back(plan_.tree[part].task);
        }
      }
      out.push_back(std::move(preference));
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const Preference& left, const Preference& right) {
    return left.order < right.order;
  });
  return out;
}

}  // namespace skein::htn
