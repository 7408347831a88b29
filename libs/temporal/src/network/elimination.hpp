// SPDX-License-Identifier: Apache-2.0
// The elimination of the inner nodes of one component of a local network. Source: M 3.7.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// A component: inner nodes (not on the frontier) and the frontier nodes, v0 among them, that arcs
/// join to them. The order of elimination (least degree first) and the edges it fills in depend on
/// the structure only and are planned once; `run` then evaluates sums of weights in that order.
class Elimination {
 public:
  /// A weight in each direction: second - first >= forward, first - second >= backward.
  struct Edge {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    Ticks forward = kMinusInfinite;
    Ticks backward = kMinusInfinite;
  };

  /// Nodes are numbered inner ones first; `arcs` join them, at least one end inner.
  Elimination(std::uint32_t inner, std::uint32_t nodes,
              const std::vector<std::pair<std::uint32_t, std::uint32_t>>& arcs);

  /// Weights of the arcs, in the order given at construction. False, and nothing changed, when the
  /// component has a positive cycle through an inner node or between two frontier nodes.
  bool run(const std::vector<std::pair<Ticks, Ticks>>& weights, std::uint64_t& checks);

  /// The edges between frontier nodes; their weights are those of the last `run` that was true.
  const std::vector<std::uint32_t>& outer_edges() const { return outer_; }
  const Edge& edge(std::uint32_t edge) const { return edges_[edge]; }

 private:
  struct Spoke {
    std::uint32_t edge;
    bool reversed;  ///< the eliminated node is the edge's first
  };
  /// From spoke i over the eliminated node to spoke j, i < j.
  struct Pair {
    Spoke from;
    Spoke to;
    std::uint32_t edge;
    bool reversed;  ///< the far node of `from` is the edge's second
  };
  struct Step {
    std::vector<Spoke> spokes;
    std::vector<Pair> pairs;
  };
  class Planner;

  bool run_step(const Step& step, std::vector<Edge>& edges, std::uint64_t& checks) const;

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> edge_of_arc_;
  std::vector<bool> arc_reversed_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> outer_;
};

}  // namespace skein::temporal
