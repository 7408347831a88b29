// SPDX-License-Identifier: Apache-2.0
// The graph that controllability is decided on: ordinary, lower-case and derived edges, by their
// end.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "skein/temporal/stnu_controllability.hpp"

namespace skein::temporal {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// An edge X -> Y of weight w stands for Y - X <= w. Kinds of edges:
/// - base: a bound of an arc, or "the end comes at least min after the activation";
/// - lower: activation -> end of weight min, nature may be that fast;
/// - derived: X -> activation of weight max(d - max, -min), where d is the distance from X to the
/// end. Edges are kept by the node they end in, since every search goes backwards.
class LoGraph {
 public:
  struct Edge {
    NodeIndex from = 0;
    Ticks weight = 0;  ///< kInfinite: absent for now
  };
  struct Link {
    NodeIndex activation = 0;
    NodeIndex end = 0;
    Ticks min = 0;
    Ticks max = 0;
    std::uint32_t given = 0;  ///< position in Stnu::contingent
    Ticks spread() const { return max - min; }
  };
  /// Whether arcs that are open keep a place, so that they can be closed later.
  enum class OpenBounds : std::uint8_t { kDrop, kKeep };

  /// Precondition: find_fault(network) is absent. Links with min = max become base edges.
  LoGraph(const Stnu& network, OpenBounds open);

  std::size_t node_count() const { return begin_.size() - 1; }
  std::size_t link_count() const { return links_.size(); }
  const Link& link(std::uint32_t link) const { return links_[link]; }
  std::span<const Edge> base_into(NodeIndex node) const {
    return {edges_.data() + begin_[node], edges_.data() + begin_[node + 1]};
  }
  /// The number of the first edge of base_into(node); the others follow.
  std::uint32_t first_edge(NodeIndex node) const { return begin_[node]; }
  /// The link that ends in the node, or kNone.
  std::uint32_t link_ending(NodeIndex node) const { return ending_[node]; }
  std::span<const std::uint32_t> links_activated(NodeIndex node) const {
    return {activated_.data() + activated_begin_[node],
            activated_.data() + activated_begin_[node + 1]};
  }
  /// Derived edges of a link; all end in its activation.
  const std::vector<Edge>& derived(std::uint32_t link) const { return derived_[link]; }
  void set_derived(std::uint32_t link, std::vector<Edge> edges) {
    derived_[link] = std::move(edges);
  }

  const ConflictTerm& term(std::uint32_t edge) const { return terms_[edge]; }
  const Edge& edge(std::uint32_t edge) const { return edges_[edge]; }
  NodeIndex edge_end(std::uint32_t edge) const { return ends_[edge]; }
  /// Numbers of the base edges out of a node; with OpenBounds::kKeep only.
  std::span<const std::uint32_t> base_out_of(NodeIndex node) const {
    return {out_.data() + out_begin_[node], out_.data() + out_begin_[node + 1]};
  }
  void set_weight(std::uint32_t edge, Ticks weight) { edges_[edge].weight = weight; }
  /// kNone when the bound is open and such bounds are dropped.
  std::uint32_t edge_of(std::uint32_t arc, LinkBound bound) const {
    return of_arc_[arc][bound == LinkBound::kMax ? 1 : 0];
  }

 private:
  struct Draft;
  void add_links(const Stnu& network);
  void sort_out();
  void sort_in(const std::vector<Draft>& drafts, std::size_t nodes, std::size_t arcs);

  std::vector<Edge> edges_;
  std::vector<ConflictTerm> terms_;
  std::vector<std::uint32_t> begin_;
  std::vector<NodeIndex> ends_;
  std::vector<std::uint32_t> out_, out_begin_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> ending_;
  std::vector<std::uint32_t> activated_, activated_begin_;
  std::vector<std::vector<Edge>> derived_;
  std::vector<std::array<std::uint32_t, 2>> of_arc_;
};

/// Weight of the derived edge of a node at distance d from the end of a link.
inline Ticks derived_weight(const LoGraph::Link& link, Ticks d) {
  return d - link.max > -link.min ? d - link.max : -link.min;
}

/// What a step of a path stands on. `index`: number of a base edge, or a link.
struct EdgeRef {
  enum class Kind : std::uint8_t { kBase, kLower, kDerived };
  Kind kind = Kind::kBase;
  std::uint32_t index = kNone;
};

/// One edge of a path, seen from the node it leaves.
struct PathStep {
  NodeIndex from = 0;
  NodeIndex to = 0;
  EdgeRef edge;
};

/// Calls visit(from, weight, EdgeRef) for every edge into a node. `except` is a link whose
/// lower-case edge is left out.
template <class Visit>
void for_each_edge_into(const LoGraph& graph, NodeIndex node, std::uint32_t except, Visit&& visit) {
  std::uint32_t number = graph.first_edge(node);
  for (const LoGraph::Edge& edge : graph.base_into(node)) {
    if (edge.weight != kInfinite) {
      visit(edge.from, edge.weight, EdgeRef{EdgeRef::Kind::kBase, number});
    }
    ++number;
  }
  const std::uint32_t ending = graph.link_ending(node);
  if (ending != kNone && ending != except) {
    const LoGraph::Link& link = graph.link(ending);
    visit(link.activation, link.min, EdgeRef{EdgeRef::Kind::kLower, ending});
  }
  for (const std::uint32_t link : graph.links_activated(node)) {
    for (const LoGraph::Edge& edge : graph.derived(link)) {
      visit(edge.from, edge.weight, EdgeRef{EdgeRef::Kind::kDerived, link});
    }
  }
}

}  // namespace skein::temporal
