// SPDX-License-Identifier: Apache-2.0
// The explanation of an inconsistency: a negative cycle of arcs.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "propagation.hpp"

namespace skein::temporal {
namespace {

__extension__ using Wide = __int128;  // sums of many weights near kLargest

/// A walk along the constraints, each from its source to its target for earliest dates.
using Walk = std::vector<Constraint>;

ConflictArc named(Constraint k) { return {k / 2, (k & 1) == 0 ? Bound::kLower : Bound::kUpper}; }

void append_chain(const Propagation& network, NodeIndex node, Bound bound, Walk& walk) {
  for (Constraint k = network.cause(node, bound); k != kNone;) {
    walk.push_back(k);
    k = network.cause(network.arcs().source(k, bound), bound);
  }
}

/// From the origin to the source of the pending constraint by its causes, across it, and back to
/// the origin by the causes of the other bound of its target. Whatever made the raise impossible,
/// the positive cycle is part of it.
Walk walk_of(const Propagation& network, const Propagation::Pending& pending) {
  Walk walk;
  append_chain(network, network.arcs().source(pending.constraint, pending.bound), pending.bound,
               walk);
  std::reverse(walk.begin(), walk.end());
  walk.push_back(pending.constraint);
  append_chain(network, network.arcs().target(pending.constraint, pending.bound),
               opposite(pending.bound), walk);
  if (pending.bound == Bound::kUpper) std::reverse(walk.begin(), walk.end());
  return walk;
}

/// Takes a walk apart into simple cycles and gives the first whose weights add up to more than 0.
class CycleSearch {
 public:
  explicit CycleSearch(const Propagation& network)
      : network_(network), place_(network.arcs().nodes(), kNone) {}

  std::vector<ConflictArc> in(const Walk& walk) {
    path_.clear();
    std::fill(place_.begin(), place_.end(), kNone);
    for (const Constraint k : walk) {
      place_[network_.arcs().source(k, Bound::kLower)] = static_cast<std::uint32_t>(path_.size());
      path_.push_back(k);
      const std::uint32_t start = place_[network_.arcs().target(k, Bound::kLower)];
      if (start == kNone) continue;
      if (positive_from(start)) return taken_from(start);
      drop_from(start);
    }
    return {};
  }

 private:
  bool positive_from(std::size_t start) const {
    Wide sum = 0;
    for (std::size_t i = start; i < path_.size(); ++i) sum += network_.arcs().weight(path_[i]);
    return sum > 0;
  }
  std::vector<ConflictArc> taken_from(std::size_t start) const {
    std::vector<ConflictArc> cycle;
    for (std::size_t i = start; i < path_.size(); ++i) cycle.push_back(named(path_[i]));
    return cycle;
  }
  void drop_from(std::size_t start) {
    for (std::size_t i = start; i < path_.size(); ++i) {
      place_[network_.arcs().source(path_[i], Bound::kLower)] = kNone;
    }
    path_.resize(start);
  }

  const Propagation& network_;
  std::vector<std::uint32_t> place_;  ///< of a node, where the path leaves it
  Walk path_;
};

/// One round of Bellman–Ford from a virtual source; gives a node raised in it, or kNone.
NodeIndex relax_all(const Propagation& network, std::vector<Wide>& value,
                    std::vector<Constraint>& cause) {
  NodeIndex raised = kNone;
  for (Constraint k = 0; k < 2 * network.arcs().slots(); ++k) {
    if (!network.arcs().has(k / 2) || network.arcs().weight(k) == kMinusInfinite) continue;
    const NodeIndex target = network.arcs().target(k, Bound::kLower);
    const Wide candidate =
        value[network.arcs().source(k, Bound::kLower)] + network.arcs().weight(k);
    if (candidate <= value[target]) continue;
    value[target] = candidate;
    cause[target] = k;
    raised = target;
  }
  return raised;
}

std::vector<ConflictArc> search_everywhere(const Propagation& network) {
  std::vector<Wide> value(network.arcs().nodes(), 0);
  std::vector<Constraint> cause(network.arcs().nodes(), kNone);
  NodeIndex raised = 0;
  for (std::size_t round = 0; round <= network.arcs().nodes() && raised != kNone; ++round) {
    raised = relax_all(network, value, cause);
  }
  if (raised == kNone) return {};
  const auto before = [&](NodeIndex node) {
    return network.arcs().source(cause[node], Bound::kLower);
  };
  for (std::size_t i = 0; i < network.arcs().nodes(); ++i) raised = before(raised);
  std::vector<ConflictArc> cycle;
  NodeIndex node = raised;
  do {
    cycle.push_back(named(cause[node]));
    node = before(node);
  } while (node != raised);
  std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

}  // namespace

std::vector<ConflictArc> find_conflict(const Propagation& network) {
  CycleSearch search(network);
  for (const Propagation::Pending& pending : network.pending()) {
    auto cycle = search.in(walk_of(network, pending));
    if (!cycle.empty()) return cycle;
  }
  if (network.consistent()) return {};
  return search_everywhere(network);
}

}  // namespace skein::temporal
