// SPDX-License-Identifier: Apache-2.0
// Bounds from below on a start that follow from what is bounded after it.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::supervisor {

/// Who starts everything as early as its conditions allow keeps bounds from below by itself, and
/// bounds from above only if what they are counted from did not come too early: when B begins 5 s
/// after A at the latest, and C ends before B begins, A waits for C. This is the graph of the
/// bounds of a controllable network, in which such consequences are paths.
class ImpliedBounds {
 public:
  /// Who waits comes no earlier than `least` after `node`; least >= 0.
  struct Bound {
    temporal::NodeIndex node = 0;
    temporal::Ticks least = 0;
  };

  explicit ImpliedBounds(std::size_t nodes) : out_(nodes), is_past_(nodes, false) {}

  /// to - from <= weight. `kept`: the execution sees to it by itself.
  void add(temporal::NodeIndex from, temporal::NodeIndex to, temporal::Ticks weight, bool kept);
  /// Nature may end so early what began with `start`: what the end must not come before, the start
  /// must not be that much before. To be said after the bounds.
  void may_last(temporal::NodeIndex start, temporal::NodeIndex end, temporal::Ticks least);
  /// Its date is known: nothing waits for it.
  void set_past(temporal::NodeIndex node) { is_past_[node] = true; }

  /// What a node waits for that the execution does not see to, and that does not itself wait for
  /// the node; in the order of nodes. Cost: O(bounds that lead back from what is bounded after it).
  std::vector<Bound> of(temporal::NodeIndex node) const;

 private:
  struct Edge {
    temporal::NodeIndex to = 0;
    temporal::Ticks weight = 0;
    bool kept = false;
  };
  bool bounds_another(temporal::NodeIndex node) const;
  /// `beyond`: which edges are looked at, of nodes at such a distance.
  template <class Beyond>
  std::vector<temporal::Ticks> distances(temporal::NodeIndex from, Beyond&& beyond) const;

  std::vector<std::vector<Edge>> out_;
  std::vector<bool> is_past_;
};

}  // namespace skein::supervisor
