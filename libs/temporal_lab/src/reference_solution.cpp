// SPDX-License-Identifier: Apache-2.0
// Shortest distances by Bellman–Ford: to - from <= max is an edge from -> to of length max, and
// from - to <= -min an edge to -> from of length -min.
#include "skein/temporal_lab/reference_solution.hpp"

#include <algorithm>
#include <optional>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

namespace {

// Lowers `distance[to]` if the way over `from` is shorter.
bool shorten(std::vector<Ticks>& distance, NodeIndex from, NodeIndex to, Ticks length) {
  if (distance[from] == kInfinite || length == kInfinite) return false;
  const Ticks over = distance[from] + length;
  if (over >= distance[to]) return false;
  distance[to] = over;
  return true;
}

// Distances from what `start` gives finite values to; backward: along reversed edges. Nothing if a
// cycle of negative length is met.
std::optional<std::vector<Ticks>> distances(std::vector<Ticks> start, const std::vector<Arc>& arcs,
                                            bool backward) {
  for (std::size_t pass = 0; pass <= start.size(); ++pass) {
    bool changed = false;
    for (const Arc& arc : arcs) {
      const NodeIndex from = backward ? arc.to : arc.from;
      const NodeIndex to = backward ? arc.from : arc.to;
      const Ticks back = arc.min == kMinusInfinite ? kInfinite : -arc.min;
      changed = shorten(start, from, to, arc.max) || changed;
      changed = shorten(start, to, from, back) || changed;
    }
    if (!changed) return start;
  }
  return std::nullopt;
}

std::vector<Ticks> from_node(std::size_t nodes, NodeIndex node) {
  std::vector<Ticks> start(nodes, kInfinite);
  start[node] = 0;
  return start;
}

Ticks negated(Ticks distance) { return distance == kInfinite ? kMinusInfinite : -distance; }

}  // namespace

ReferenceSolution solve_reference(std::size_t nodes, const std::vector<Arc>& arcs) {
  const bool consistent = distances(std::vector<Ticks>(nodes, 0), arcs, false).has_value();
  if (!consistent) return {};
  ReferenceSolution solution{true, std::vector<ReferenceWindow>(nodes)};
  if (nodes == 0) return solution;
  const std::optional<std::vector<Ticks>> there = distances(from_node(nodes, 0), arcs, false);
  const std::optional<std::vector<Ticks>> back = distances(from_node(nodes, 0), arcs, true);
  SKEIN_ENSURES(there && back);
  for (std::size_t node = 0; node < nodes; ++node) {
    solution.windows[node] = {negated((*back)[node]), (*there)[node]};
  }
  return solution;
}

ReferenceSolution solve_reference(const Mastn& mastn) {
  return solve_reference(mastn.nodes.size(), mastn.arcs);
}

ReferenceWindow implied_interval(std::size_t nodes, const std::vector<Arc>& arcs, NodeIndex from,
                                 NodeIndex to) {
  const std::optional<std::vector<Ticks>> there = distances(from_node(nodes, from), arcs, false);
  const std::optional<std::vector<Ticks>> back = distances(from_node(nodes, from), arcs, true);
  SKEIN_EXPECTS(there && back);
  return {negated((*back)[to]), (*there)[to]};
}

}  // namespace skein::temporal
