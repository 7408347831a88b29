// SPDX-License-Identifier: Apache-2.0
// Bellman-Ford with alternating sweeps (Yen), in an order in which they are few, for the whole
// graph, Dijkstra on reduced weights for new edges.
#include "best_case_schedule.hpp"

#include <algorithm>

#include "network/sweep_order.hpp"

namespace skein::temporal {

namespace {

constexpr Ticks kLatestDate = 2 * kLargest;

// Y - X <= w with w <= 0: X comes no earlier than Y.
std::vector<NodeIndex> order_of(const LoGraph& graph) {
  std::vector<Precedence> precedences;
  for (NodeIndex node = 0; node < graph.node_count(); ++node) {
    for_each_edge_into(graph, node, kNone, [&](NodeIndex from, Ticks weight, EdgeRef) {
      if (weight <= 0 && from != node) precedences.push_back({node, from});
    });
  }
  return sweep_order(graph.node_count(), precedences);
}

}  // namespace

BestCaseSchedule::BestCaseSchedule(std::size_t nodes)
    : dates_(nodes, 0), active_(nodes, 0), settled_(nodes, 0), queue_(nodes) {}

void BestCaseSchedule::add_node() {
  dates_.push_back(0);
  active_.push_back(0);
  settled_.push_back(0);
  queue_.grow();
}

BestCaseSchedule::Outcome BestCaseSchedule::solve(const LoGraph& graph, bool slowest) {
  parents_.assign(dates_.size(), {});
  std::fill(active_.begin(), active_.end(), std::uint8_t{1});
  moves_since_check_ = 0;
  const std::vector<NodeIndex> order = order_of(graph);
  sweeps_ = 0;
  for (bool forward = true;; forward = !forward) {
    ++sweeps_;
    switch (sweep(graph, slowest, order, forward)) {
      case SweepResult::kQuiet:
        return Outcome::kDone;
      case SweepResult::kMoved:
        break;
      case SweepResult::kCycle:
        return Outcome::kCycle;
      case SweepResult::kOverflow:
        return Outcome::kOverflow;
    }
  }
}

BestCaseSchedule::SweepResult BestCaseSchedule::sweep(const LoGraph& graph, bool slowest,
                                                      const std::vector<NodeIndex>& order,
                                                      bool forward) {
  bool moved = false;
  const std::size_t nodes = dates_.size();
  for (std::size_t i = 0; i < nodes; ++i) {
    const NodeIndex node = order[forward ? i : nodes - 1 - i];
    if (active_[node] == 0) continue;
    active_[node] = 0;
    const SweepResult result = pull(graph, node, slowest);
    if (result == SweepResult::kOverflow) {
      return find_parent_cycle() ? SweepResult::kCycle : SweepResult::kOverflow;
    }
    moved = moved || result == SweepResult::kMoved;
    if (moves_since_check_ > nodes) {
      moves_since_check_ = 0;
      if (find_parent_cycle()) return SweepResult::kCycle;
    }
  }
  return moved ? SweepResult::kMoved : SweepResult::kQuiet;
}

BestCaseSchedule::SweepResult BestCaseSchedule::pull(const LoGraph& graph, NodeIndex node,
                                                     bool slowest) {
  SweepResult result = SweepResult::kQuiet;
  for_each_edge_into(graph, node, kNone, [&](NodeIndex from, Ticks weight, EdgeRef edge) {
    if (slowest && edge.kind == EdgeRef::Kind::kDerived) return;
    if (slowest && edge.kind == EdgeRef::Kind::kLower) weight = graph.link(edge.index).max;
    if (dates_[node] > kLatestDate || dates_[node] - weight <= dates_[from]) return;
    dates_[from] = dates_[node] - weight;
    parents_[from] = {node, edge};
    active_[from] = 1;
    ++moves_since_check_;
    if (result == SweepResult::kQuiet) result = SweepResult::kMoved;
    if (dates_[from] > kLatestDate) result = SweepResult::kOverflow;
  });
  return result;
}

// Follows parents from every node; each walk has its own mark.
bool BestCaseSchedule::find_parent_cycle() {
  mark_.assign(dates_.size(), kNone);
  for (NodeIndex start = 0; start < dates_.size(); ++start) {
    NodeIndex node = start;
    while (node != kNone && mark_[node] == kNone) {
      mark_[node] = start;
      node = parents_[node].next;
    }
    if (node != kNone && mark_[node] == start) {
      read_cycle(node);
      return true;
    }
  }
  return false;
}

void BestCaseSchedule::read_cycle(NodeIndex on_cycle) {
  cycle_.clear();
  NodeIndex node = on_cycle;
  do {
    cycle_.push_back({node, parents_[node].next, parents_[node].edge});
    node = parents_[node].next;
  } while (node != on_cycle);
}

// A cycle made of new edges goes through `target`, so it exists iff the target has to move itself.
BestCaseSchedule::Outcome BestCaseSchedule::add_edges(const LoGraph& graph, NodeIndex target,
                                                      const std::vector<Seed>& seeds) {
  parents_.resize(dates_.size());
  moved_.clear();
  for (const Seed& seed : seeds) {
    const Ticks rise = dates_[target] - seed.weight - dates_[seed.from];
    if (rise > 0 && queue_.lower(seed.from, -rise)) parents_[seed.from] = {target, seed.edge};
  }
  bool cycle = false;
  bool overflow = false;
  while (!queue_.empty() && !cycle) {
    const NodeIndex node = queue_.pop();
    const Ticks rise = -queue_.key(node);
    cycle = node == target;
    overflow = overflow || dates_[node] + rise > kLatestDate;
    settled_[node] = 1;
    moved_.emplace_back(node, rise);
    if (!cycle) move_earlier_nodes(graph, node, rise);
  }
  queue_.clear();
  for (const auto& [node, rise] : moved_) settled_[node] = 0;
  if (cycle) {
    read_cycle(target);
    return Outcome::kCycle;
  }
  if (overflow) return Outcome::kOverflow;
  for (const auto& [node, rise] : moved_) dates_[node] += rise;
  return Outcome::kDone;
}

void BestCaseSchedule::move_earlier_nodes(const LoGraph& graph, NodeIndex node, Ticks rise) {
  for_each_edge_into(graph, node, kNone, [&](NodeIndex from, Ticks weight, EdgeRef edge) {
    const Ticks left = rise - (weight + dates_[from] - dates_[node]);
    if (left <= 0 || settled_[from] != 0) return;
    if (queue_.lower(from, -left)) parents_[from] = {node, edge};
  });
}

}  // namespace skein::temporal
