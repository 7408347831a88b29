// SPDX-License-Identifier: Apache-2.0
#include "sweep_order.hpp"

#include <algorithm>

namespace skein::temporal {

namespace {

/// Depth-first search without recursion; nodes in the order in which they are left.
class Search {
 public:
  Search(std::size_t nodes, const std::vector<Precedence>& precedences)
      : begin_(nodes + 1, 0), after_(precedences.size()), seen_(nodes, 0) {
    for (const Precedence& one : precedences) ++begin_[one.before + 1];
    for (std::size_t node = 0; node < nodes; ++node) begin_[node + 1] += begin_[node];
    next_.assign(begin_.begin(), begin_.end() - 1);
    for (const Precedence& one : precedences) after_[next_[one.before]++] = one.after;
    next_.assign(begin_.begin(), begin_.end() - 1);
    left_.reserve(nodes);
  }

  void visit(NodeIndex start) {
    if (seen_[start] != 0) return;
    enter(start);
    while (!open_.empty()) {
      const NodeIndex node = open_.back();
      if (next_[node] == begin_[node + 1]) {
        left_.push_back(node);
        open_.pop_back();
      } else {
        const NodeIndex after = after_[next_[node]++];
        if (seen_[after] == 0) enter(after);
      }
    }
  }

  std::vector<NodeIndex> take_left() { return std::move(left_); }

 private:
  void enter(NodeIndex node) {
    seen_[node] = 1;
    open_.push_back(node);
  }

  std::vector<std::size_t> begin_;  ///< of each node, where its successors begin in after_
  std::vector<NodeIndex> after_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::size_t> next_;
  std::vector<NodeIndex> open_;
  std::vector<NodeIndex> left_;
};

}  // namespace

std::vector<NodeIndex> sweep_order(std::size_t nodes, const std::vector<Precedence>& precedences) {
  Search search(nodes, precedences);
  for (NodeIndex node = 0; node < nodes; ++node) search.visit(node);
  std::vector<NodeIndex> order = search.take_left();
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace skein::temporal
