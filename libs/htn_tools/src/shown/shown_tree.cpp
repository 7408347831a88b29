// SPDX-License-Identifier: Apache-2.0
#include "shown/shown_tree.hpp"

#include <algorithm>

namespace skein::htn {

std::vector<TreeIndex> ShownTree::top() const {
  if (plan_.tree.empty()) return {};
  return expand({0});
}

std::vector<TreeIndex> ShownTree::below(TreeIndex index) const {
  const std::vector<TreeIndex>& children = plan_.tree[index].children;
  return expand({children.rbegin(), children.rend()});
}

std::vector<CausalLink> ShownTree::made(TreeIndex index) const {
  std::vector<CausalLink> links;
  for (const CausalLink& link : plan_.tree[index].support) {
    const bool known = std::find(links.begin(), links.end(), link) != links.end();
    if (link.step != kInitialState && !known) links.push_back(link);
  }
  return links;
}

std::string ShownTree::operator_of(StepIndex step, const TermStore& store) const {
  if (step >= plan_.steps.size()) return "";
  const Term action = plan_.steps[step].action;
  return store.to_text(action.is(TermKind::kPair) ? store.car(action) : action);
}

// A step that was left out, or one that does nothing.
bool ShownTree::hidden(const TreeNode& node) const {
  return node.kind == TreeNodeKind::kStep && numbers_[node.step] == kNoStep;
}

// A network of one child, and an ordered one below a task or an ordered network, add nothing.
bool ShownTree::transparent(TreeIndex index) const {
  const TreeNode& node = plan_.tree[index];
  if (node.kind != TreeNodeKind::kOrdered && node.kind != TreeNodeKind::kUnordered) return false;
  const auto shown = std::count_if(node.children.begin(), node.children.end(),
                                   [&](TreeIndex at) { return !hidden(plan_.tree[at]); });
  if (shown <= 1) return true;
  return node.kind == TreeNodeKind::kOrdered &&
         (node.parent == kNoParent || plan_.tree[node.parent].kind != TreeNodeKind::kUnordered);
}

// `open` is a stack: its last element comes first.
std::vector<TreeIndex> ShownTree::expand(std::vector<TreeIndex> open) const {
  std::vector<TreeIndex> shown;
  while (!open.empty()) {
    const TreeIndex at = open.back();
    open.pop_back();
    const TreeNode& node = plan_.tree[at];
    if (hidden(node)) continue;
    if (transparent(at)) {
      open.insert(open.end(), node.children.rbegin(), node.children.rend());
    } else {
      shown.push_back(at);
    }
  }
  return shown;
}

}  // namespace skein::htn
