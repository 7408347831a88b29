// SPDX-License-Identifier: Apache-2.0
// Shortest distances to the end of a contingent link, as far as its uncertainty carries them.
#pragma once

#include <vector>

#include "best_case_schedule.hpp"

namespace skein::temporal {

/// Backward Dijkstra from the end of a link, on weights reduced by the schedule. A node at a
/// distance of spread() or more is reached but not passed: beyond it, the derived edge carries on
/// from the activation. The scratch memory is reused from search to search.
class LinkSearch {
 public:
  explicit LinkSearch(std::size_t nodes)
      : queue_(nodes), reached_(nodes, 0), distance_(nodes), via_(nodes) {}

  /// Adds a node, for growing graphs.
  void add_node();

  /// Searches from the end of `link`. Needs the links activated at nodes it passes to be `ready`:
  /// returns one that is not, or kNone when the search is complete. Without `ready` all count as
  /// ready.
  std::uint32_t run(const LoGraph& graph, const BestCaseSchedule& schedule, std::uint32_t link,
                    const std::vector<std::uint8_t>* ready);

  struct Via {
    NodeIndex next = kNone;
    EdgeRef edge;
  };
  /// A copy of the last search. Distances and edges are those of settled nodes; others have no
  /// meaning.
  struct Table {
    std::vector<Ticks> distance;
    std::vector<Via> via;
    /// Edges from a settled node to the end of the link.
    std::vector<PathStep> path_from(NodeIndex node, NodeIndex end) const;
  };
  Table snapshot() const { return {distance_, via_}; }

  /// Nodes of the last search, in the order settled.
  const std::vector<NodeIndex>& settled() const { return settled_; }
  /// Distance of a settled node to the end of the link.
  Ticks distance(NodeIndex node) const { return distance_[node]; }
  bool reached(NodeIndex node) const { return reached_[node] == kSettled; }
  /// The edges that follow from the last search; those that the graph implies are left out.
  std::vector<LoGraph::Edge> derived_edges(const LoGraph::Link& link) const;
  /// Edges looked at by all searches so far.
  std::uint64_t relaxations() const { return relaxations_; }

 private:
  enum : std::uint8_t { kUnseen, kQueued, kSettled };

  void reset();
  void pass(const LoGraph& graph, const BestCaseSchedule& schedule, NodeIndex node,
            std::uint32_t link);

  IndexedHeap<Ticks> queue_;
  std::vector<std::uint8_t> reached_;
  std::vector<Ticks> distance_;
  std::vector<Via> via_;
  std::vector<NodeIndex> touched_, settled_;
  std::uint64_t relaxations_ = 0;
};

/// The link's derived edge of a node at distance d is worth keeping: the path through the end of
/// the link is not as short.
inline bool derives_edge(const LoGraph::Link& link, NodeIndex node, Ticks d) {
  return d > 0 && d != kInfinite && node != link.activation;
}

}  // namespace skein::temporal
