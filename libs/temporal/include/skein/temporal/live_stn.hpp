// SPDX-License-Identifier: Apache-2.0
// A simple temporal network with links that are added and removed under ids of the caller.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "skein/temporal/stn_engine.hpp"

namespace skein::temporal {

/// Keeps dates under links that are set and erased one by one; several may join the same two nodes,
/// and contradict each other. `settle` propagates all changes together: incrementally, or from
/// scratch if most of the network changed. Node 0 is the origin; nodes exist as long as links refer
/// to them. Thread rule: not safe to share. Source: spec 5.1.
class LiveStn {
 public:
  using LinkId = std::uint64_t;

  /// Adds a link, or changes its nodes or bounds. Bounds may be infinite. Precondition: from != to,
  /// min <= max.
  void set(LinkId link, const Arc& arc);
  /// Removes a link; no effect if there is none of this id.
  void erase(LinkId link);
  void settle();

  /// After settle(): a solution exists, with dates within ±kLargest.
  bool consistent() const { return !overflowed_ && engine_.consistent(); }
  /// Date of a node. Precondition: settle() was called, and the network is consistent. A node
  /// without links is unbounded.
  Ticks earliest(NodeIndex node) const;
  Ticks latest(NodeIndex node) const;

 private:
  /// One difference constraint: to - from >= weight.
  using Pair = std::uint64_t;
  struct Bound {
    LinkId link = 0;
    Ticks weight = 0;
  };
  struct Constraint {
    std::vector<Bound> bounds;
    std::optional<ArcId> arc;
    Ticks applied = kMinusInfinite;
    Ticks weight() const;
  };
  static Pair pair_of(NodeIndex from, NodeIndex to) { return (Pair{from} << 32U) | to; }

  void bound(Pair pair, LinkId link, Ticks weight);
  void free(Pair pair, LinkId link);
  void drop(LinkId link, const Arc& arc);
  void apply(Pair pair, std::vector<ArcBounds>& changed, std::vector<ArcId>& removed);
  void insert(Pair pair);
  void rebuild();

  std::unordered_map<LinkId, Arc> links_;
  std::unordered_map<Pair, Constraint> constraints_;
  std::set<Pair> touched_;
  NodeIndex nodes_ = 1;  ///< asked for; the engine may have fewer until settle()
  StnEngine engine_;
  bool overflowed_ = false;
};

}  // namespace skein::temporal
