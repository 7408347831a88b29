// SPDX-License-Identifier: Apache-2.0
// A schedule for least contingent durations; also the potential function of the searches.
#pragma once

#include <vector>

#include "lo_graph.hpp"
#include "network/indexed_heap.hpp"

namespace skein::temporal {

/// Dates >= 0 of all nodes that satisfy every edge of a LoGraph: date(Y) - date(X) <= w. Hence
/// w + date(X) - date(Y) >= 0, which is what Dijkstra's algorithm asks of weights.
class BestCaseSchedule {
 public:
  enum class Outcome : std::uint8_t { kDone, kCycle, kOverflow };
  /// The requirement of a new edge.
  struct Seed {
    NodeIndex from = 0;
    Ticks weight = 0;
    EdgeRef edge;
  };

  explicit BestCaseSchedule(std::size_t nodes);
  /// Adds a node without edges.
  void add_node();

  Ticks date(NodeIndex node) const { return dates_[node]; }
  const std::vector<Ticks>& dates() const { return dates_; }
  void restore(std::vector<Ticks> dates) { dates_ = std::move(dates); }

  /// Computes dates that satisfy the graph, starting from the current ones. `slowest` reads
  /// lower-case edges with max instead of min: consistency with contingent links as requirements.
  /// The order of sweeps does not depend on that of the file: plans need few; O(n m) at worst.
  /// After kCycle or kOverflow the dates are invalid.
  Outcome solve(const LoGraph& graph, bool slowest);

  /// Updates the dates for new edges into `target`, which may or may not be in the graph already.
  /// After kCycle or kOverflow the dates are unchanged. O(m + n log n) of the affected part.
  Outcome add_edges(const LoGraph& graph, NodeIndex target, const std::vector<Seed>& seeds);

  /// Number of sweeps over all nodes in the last `solve`.
  std::size_t sweeps() const { return sweeps_; }

  /// After kCycle: the edges of the negative cycle, in order.
  const std::vector<PathStep>& cycle() const { return cycle_; }

 private:
  struct Parent {
    NodeIndex next = kNone;
    EdgeRef edge;
  };
  enum class SweepResult : std::uint8_t { kQuiet, kMoved, kCycle, kOverflow };

  SweepResult sweep(const LoGraph& graph, bool slowest, const std::vector<NodeIndex>& order,
                    bool forward);
  SweepResult pull(const LoGraph& graph, NodeIndex node, bool slowest);
  bool find_parent_cycle();
  void read_cycle(NodeIndex on_cycle);
  void move_earlier_nodes(const LoGraph& graph, NodeIndex node, Ticks rise);

  std::vector<Ticks> dates_;
  std::vector<Parent> parents_;
  std::vector<std::uint8_t> active_;
  std::vector<std::uint32_t> mark_;
  std::vector<PathStep> cycle_;
  std::vector<std::pair<NodeIndex, Ticks>> moved_;
  std::vector<std::uint8_t> settled_;
  IndexedHeap<Ticks> queue_;
  std::size_t moves_since_check_ = 0;
  std::size_t sweeps_ = 0;
};

}  // namespace skein::temporal
