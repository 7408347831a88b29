// SPDX-License-Identifier: Apache-2.0
// The graph that controllability is decided on: ordinary, lower-case and derived edges, by their
// end.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
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
  /// A base edge as the node it ends in sees it.
  struct InEdge {
    NodeIndex from = 0;
    std::uint32_t number = 0;
    Ticks weight = 0;  ///< kInfinite: absent for now
  };
  struct Link {
    NodeIndex activation = 0;
    NodeIndex end = 0;
    Ticks min = 0;
    Ticks max = 0;
    std::uint32_t given = 0;  ///< position in Stnu::contingent
    std::uint32_t base = 0;   ///< number of its base edge, end -> activation
    Ticks spread() const { return max - min; }
  };
  /// Whether arcs that are open keep a place, so that they can be closed later.
  enum class OpenBounds : std::uint8_t { kDrop, kKeep };

  /// Precondition: find_fault(network) is absent. Links with min = max become base edges.
  LoGraph(const Stnu& network, OpenBounds open);

  std::size_t node_count() const { return into_.size(); }
  /// Places of links, those of links that went away too.
  std::size_t link_count() const { return links_.size(); }
  const Link& link(std::uint32_t link) const { return links_[link]; }
  const std::vector<InEdge>& base_into(NodeIndex node) const { return into_[node]; }
  /// The link that ends in the node, or kNone.
  std::uint32_t link_ending(NodeIndex node) const { return ending_[node]; }
  const std::vector<std::uint32_t>& links_activated(NodeIndex node) const {
    return activated_[node];
  }
  /// Derived edges of a link; all end in its activation.
  const std::vector<Edge>& derived(std::uint32_t link) const { return derived_[link]; }
  void set_derived(std::uint32_t link, std::vector<Edge> edges) {
    derived_[link] = std::move(edges);
  }

  const ConflictTerm& term(std::uint32_t edge) const { return terms_[edge]; }
  Edge edge(std::uint32_t edge) const {
    const InEdge& in = into_[places_[edge].end][places_[edge].at];
    return {in.from, in.weight};
  }
  NodeIndex edge_end(std::uint32_t edge) const { return places_[edge].end; }
  /// Numbers of the base edges out of a node; with OpenBounds::kKeep only.
  const std::vector<std::uint32_t>& base_out_of(NodeIndex node) const { return out_[node]; }
  void set_weight(std::uint32_t edge, Ticks weight) {
    into_[places_[edge].end][places_[edge].at].weight = weight;
  }
  /// kNone when the bound is open and such bounds are dropped.
  std::uint32_t edge_of(std::uint32_t arc, LinkBound bound) const {
    return of_arc_[arc][bound == LinkBound::kMax ? 1 : 0];
  }
  /// The link of a position in Stnu::contingent; kNone when that has min = max.
  std::uint32_t link_of(std::uint32_t contingent) const { return of_contingent_[contingent]; }

  // Changes of structure; with OpenBounds::kKeep only.
  void add_node();
  /// A place for an arc between these nodes, open; the last one of the network.
  void add_arc(NodeIndex from, NodeIndex to);
  /// Precondition: the arc is open.
  void move_arc(std::uint32_t arc, NodeIndex from, NodeIndex to);
  /// The last one of the network, with min < max. Its base edge is absent and it counts neither as
  /// ending nor as activated until `activate`.
  std::uint32_t add_link(const ContingentLink& given);
  void activate(std::uint32_t link);
  /// Precondition: it has no derived edges any more, and its base edge is absent.
  void remove_link(std::uint32_t link);
  /// Two contingent links change positions.
  void exchange(std::uint32_t one, std::uint32_t other);

 private:
  struct Place {
    NodeIndex end = 0;
    std::uint32_t at = 0;      ///< in into_[end]
    std::uint32_t out_at = 0;  ///< in out_[from]
  };
  std::uint32_t add_edge(NodeIndex from, NodeIndex to, Ticks weight, ConflictTerm term);
  void link_edge(std::uint32_t edge, NodeIndex from, NodeIndex to, Ticks weight);
  void unlink_edge(std::uint32_t edge);
  void add_links(const Stnu& network);
  void put(std::uint32_t link, std::uint32_t position);

  bool keeps_open_;
  std::vector<std::vector<InEdge>> into_;
  std::vector<std::vector<std::uint32_t>> out_;
  std::vector<Place> places_;
  std::vector<ConflictTerm> terms_;
  std::vector<std::uint32_t> free_edges_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> free_links_;
  std::vector<std::uint32_t> ending_;
  std::vector<std::vector<std::uint32_t>> activated_;
  std::vector<std::vector<Edge>> derived_;
  std::vector<std::array<std::uint32_t, 2>> of_arc_;
  std::vector<std::uint32_t> of_contingent_;
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
  for (const LoGraph::InEdge& edge : graph.base_into(node)) {
    if (edge.weight != kInfinite) {
      visit(edge.from, edge.weight, EdgeRef{EdgeRef::Kind::kBase, edge.number});
    }
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
