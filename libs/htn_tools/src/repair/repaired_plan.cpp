// SPDX-License-Identifier: Apache-2.0
#include "repair/repaired_plan.hpp"

#include <algorithm>
#include <unordered_map>

#include "repair/tree_walk.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/htn/term_map.hpp"

namespace skein::htn {

namespace {

/// Copies nodes of two trees into a third, parents first.
class Merger {
 public:
  Merger(const Plan& old, const OldTree& tree, const RemainingTasks& remaining, const Plan& made,
         StepIndex executed)
      : old_(old), tree_(tree), made_(made), placed_(executed, false) {
    const std::vector<TreeIndex> tops = topmost_tasks(made.tree, {0});
    SKEIN_EXPECTS(tops.size() == remaining.leaves.size());
    for (std::size_t at = 0; at < tops.size(); ++at) new_[remaining.leaves[at]] = tops[at];
  }

  std::vector<TreeNode> merge() {
    copy({&old_, 0, kNoParent});
    std::vector<StepIndex> homeless;
    for (StepIndex step = 0; step < placed_.size(); ++step) {
      if (!placed_[step]) homeless.push_back(step);
    }
    if (homeless.empty()) return std::move(out_);
    out_.clear();
    add_network(TreeNodeKind::kUnordered, kNoParent);
    const TreeIndex before = add_network(TreeNodeKind::kOrdered, 0);
    for (const StepIndex step : homeless) copy({&old_, tree_.leaf_of(step), before});
    copy({&old_, 0, 0});
    return std::move(out_);
  }

 private:
  struct Open {
    const Plan* source;
    TreeIndex node;
    TreeIndex parent;
  };

  TreeIndex place(TreeNode node, TreeIndex parent) {
    const auto index = static_cast<TreeIndex>(out_.size());
    node.parent = parent;
    node.children.clear();
    if (node.step < placed_.size()) placed_[node.step] = true;
    out_.push_back(std::move(node));
    if (parent != kNoParent) out_[parent].children.push_back(index);
    return index;
  }
  TreeIndex add_network(TreeNodeKind kind, TreeIndex parent) {
    TreeNode node;
    node.kind = kind;
    return place(std::move(node), parent);
  }

  void copy(Open first) {
    std::vector<Open> open{first};
    while (!open.empty()) {
      Open next = open.back();
      open.pop_back();
      const auto renewed = new_.find(next.node);
      const bool again = next.source == &old_ && renewed != new_.end();
      if (again) next = {&made_, renewed->second, next.parent};
      const TreeNode& node = next.source->tree[next.node];
      const TreeIndex self = place(node, next.parent);
      if (again) out_[self].immediate = old_.tree[renewed->first].immediate;
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
        open.push_back({next.source, *child, self});
      }
    }
  }

  const Plan& old_;
  const OldTree& tree_;
  const Plan& made_;
  std::vector<bool> placed_;  // executed steps
  std::unordered_map<TreeIndex, TreeIndex> new_;
  std::vector<TreeNode> out_;
};

bool same_reduction(const std::vector<TreeNode>& left, TreeIndex one,
                    const std::vector<TreeNode>& right, TreeIndex other, TermStore& store) {
  const auto same = [&](TreeIndex a, TreeIndex b) {
    return renumbered(left[a].task, store) == renumbered(right[b].task, store);
  };
  const TreeNode& old = left[one];
  const TreeNode& made = right[other];
  if (old.kind != made.kind || old.method != made.method) return false;
  if (old.kind == TreeNodeKind::kStep) return same(one, other);
  const std::vector<TreeIndex> parts = subtask_nodes(left, one);
  const std::vector<TreeIndex> others = subtask_nodes(right, other);
  return std::equal(parts.begin(), parts.end(), others.begin(), others.end(), same);
}

}  // namespace

Term renumbered(Term term, TermStore& store) {
  std::vector<Term> known;
  return map_leaves(store, term, kHasVariable | kHasLocal, [&](Term variable) {
    const auto at = std::find(known.begin(), known.end(), variable);
    const auto number = static_cast<std::uint32_t>(at - known.begin());
    if (at == known.end()) known.push_back(variable);
    return Term(TermKind::kLocal, number);
  });
}

std::vector<TreeNode> merged_tree(const Plan& old, const OldTree& tree,
                                  const RemainingTasks& remaining, const Plan& made,
                                  StepIndex executed) {
  return Merger(old, tree, remaining, made, executed).merge();
}

std::vector<Redone> redone_tasks(const Plan& old, const OldTree& tree,
                                 const RemainingTasks& remaining, const Plan& made,
                                 const std::vector<TreeIndex>& again, TermStore& store) {
  std::vector<Redone> out;
  std::vector<std::pair<TreeIndex, TreeIndex>> open;
  const std::vector<TreeIndex> tops = topmost_tasks(made.tree, {0});
  for (std::size_t at = tops.size(); at-- > 0;) open.emplace_back(remaining.leaves[at], tops[at]);
  while (!open.empty()) {
    const auto [one, other] = open.back();
    open.pop_back();
    const bool anew = std::find(again.begin(), again.end(), one) != again.end();
    if (anew || !same_reduction(old.tree, one, made.tree, other, store)) {
      out.push_back({old.tree[one].task, tree.in_progress(one)});
      continue;
    }
    const std::vector<TreeIndex> parts = subtask_nodes(old.tree, one);
    const std::vector<TreeIndex> others = subtask_nodes(made.tree, other);
    for (std::size_t at = parts.size(); at-- > 0;) open.emplace_back(parts[at], others[at]);
  }
  return out;
}

void compare_steps(const Plan& old, StepIndex executed, TermStore& store, Repair& repair) {
  std::unordered_map<Term, std::vector<StepIndex>> left;  // the last is the first to be taken
  for (auto step = static_cast<StepIndex>(old.steps.size()); step-- > executed;) {
    left[renumbered(old.steps[step].action, store)].push_back(step);
  }
  std::vector<bool> taken(old.steps.size(), false);
  for (StepIndex step = executed; step < repair.plan.steps.size(); ++step) {
    const auto same = left.find(renumbered(repair.plan.steps[step].action, store));
    if (same == left.end() || same->second.empty()) {
      repair.added.push_back(step);
      continue;
    }
    repair.kept.push_back(step);
    taken[same->second.back()] = true;
    same->second.pop_back();
  }
  for (StepIndex step = executed; step < old.steps.size(); ++step) {
    if (!taken[step]) repair.dropped.push_back(step);
  }
}

}  // namespace skein::htn
