// SPDX-License-Identifier: Apache-2.0
// The arcs of a network, found from each of their nodes, with the weights of their constraints.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "skein/temporal/network.hpp"
#include "skein/temporal/stn_engine.hpp"

namespace skein::temporal {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Constraint 2a of arc a: to - from >= min; 2a + 1: from - to >= -max. Both kinds of bounds are
/// "value(target) >= value(source) + weight": earliest dates go with the constraint, latest dates
/// are stored negated and go against it.
using Constraint = std::uint32_t;
inline constexpr Bound kBounds[] = {Bound::kLower, Bound::kUpper};
constexpr std::uint32_t side(Bound bound) { return static_cast<std::uint32_t>(bound); }

/// The weights of the two constraints of an arc; kMinusInfinite: no constraint.
constexpr Ticks weight_of_min(Ticks min) { return min; }
constexpr Ticks weight_of_max(Ticks max) { return max == kInfinite ? kMinusInfinite : -max; }

/// Ids of removed arcs are reused, the last first. Callers check their arguments.
class ArcTable {
 public:
  void add_node() { first_.push_back(kNone); }
  /// Removes the last node. Precondition: it has no arcs.
  void drop_node() { first_.pop_back(); }
  /// Adds an arc; its weights must be set afterwards.
  ArcId add(NodeIndex from, NodeIndex to);
  void remove(ArcId arc);
  /// Restores the arc that was removed last.
  void put_back(ArcId arc, NodeIndex from, NodeIndex to);

  void set_weight(Constraint k, Ticks weight) { weights_[k] = weight; }
  Ticks weight(Constraint k) const { return weights_[k]; }
  NodeIndex source(Constraint k, Bound bound) const { return ends_[k ^ side(bound)].node; }
  NodeIndex target(Constraint k, Bound bound) const { return ends_[k ^ side(bound) ^ 1].node; }
  NodeIndex from(ArcId arc) const { return ends_[2 * arc].node; }
  NodeIndex to(ArcId arc) const { return ends_[2 * arc + 1].node; }

  bool has(ArcId arc) const { return arc < slots() && from(arc) != kNone; }
  Arc arc(ArcId arc) const;
  /// Cost: the lesser of the numbers of arcs at both.
  std::optional<ArcId> find(NodeIndex from, NodeIndex to) const;
  std::size_t nodes() const { return first_.size(); }
  std::size_t slots() const { return ends_.size() / 2; }
  std::size_t count() const { return slots() - free_.size(); }

  /// Calls `visit(end)` for each end of an arc at the node: 2a of arc a from it, 2a + 1 to it.
  template <class Visit>
  void each_end(NodeIndex node, const Visit& visit) const {
    for (std::uint32_t end = first_[node]; end != kNone; end = ends_[end].next) visit(end);
  }

  std::size_t memory_bytes() const;  ///< beside the object itself
  void shrink();

 private:
  struct End {
    NodeIndex node = kNone;
    std::uint32_t next = kNone;
    std::uint32_t previous = kNone;
  };

  void link(std::uint32_t end, NodeIndex node);
  void unlink(std::uint32_t end);

  std::vector<std::uint32_t> first_;  ///< of each node, its first end
  std::vector<End> ends_;             ///< 2a: arc a at its `from`; 2a + 1: at its `to`
  std::vector<Ticks> weights_;
  std::vector<ArcId> free_;
};

}  // namespace skein::temporal
