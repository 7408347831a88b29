// SPDX-License-Identifier: Apache-2.0
// Traversals of decomposition trees, without recursion.
#pragma once

#include <vector>

#include "skein/htn/plan.hpp"

namespace skein::htn {

inline bool is_network(const TreeNode& node) {
  return node.kind == TreeNodeKind::kOrdered || node.kind == TreeNodeKind::kUnordered;
}

/// The topmost tasks and steps below `from` (or `from` itself), in order.
inline std::vector<TreeIndex> topmost_tasks(const std::vector<TreeNode>& tree,
                                            std::vector<TreeIndex> from) {
  std::vector<TreeIndex> found;
  std::vector<TreeIndex> open(from.rbegin(), from.rend());
  while (!open.empty()) {
    const TreeIndex at = open.back();
    open.pop_back();
    if (is_network(tree[at])) {
      open.insert(open.end(), tree[at].children.rbegin(), tree[at].children.rend());
    } else {
      found.push_back(at);
    }
  }
  return found;
}

/// The tasks and steps of the reduction of a task.
inline std::vector<TreeIndex> subtask_nodes(const std::vector<TreeNode>& tree, TreeIndex task) {
  return topmost_tasks(tree, tree[task].children);
}

}  // namespace skein::htn
