// SPDX-License-Identifier: Apache-2.0
// Lower bounds on starts that are implied by upper bounds on later events.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::supervisor {

/// An execution that starts each task as early as its conditions allow keeps all lower bounds, but
/// an upper bound only if the event from which it counts did not come too early: if B begins at
/// most 5 s after A, and C ends before B begins, A must wait for C. This is the distance graph of a
/// controllable network, in which such implied waits are paths.
class ImpliedBounds {
 public:
  /// The waiting node comes no earlier than `least` after `node`; least >= 0.
  struct Bound {
    temporal::NodeIndex node = 0;
    temporal::Ticks least = 0;
  };

  explicit ImpliedBounds(std::size_t nodes) : out_(nodes), is_past_(nodes, false) {}

  /// Adds to - from <= weight. `kept`: an earliest execution keeps this bound by itself.
  void add(temporal::NodeIndex from, temporal::NodeIndex to, temporal::Ticks weight, bool kept);
  /// Adds a contingent link of least duration `least`: whatever the end must not precede, the start
  /// must not precede by more than `least`. To be called after all add().
  void may_last(temporal::NodeIndex start, temporal::NodeIndex end, temporal::Ticks least);
  /// Its date is known: nothing waits for it.
  void set_past(temporal::NodeIndex node) { is_past_[node] = true; }

  /// The implied waits of `node` that an earliest execution does not keep by itself, except on
  /// nodes that wait for `node`; in the order of nodes. Cost: O(bounds on paths back from later
  /// events that are bounded by `node`).
  std::vector<Bound> of(temporal::NodeIndex node) const;

 private:
  struct Edge {
    temporal::NodeIndex to = 0;
    temporal::Ticks weight = 0;
    bool kept = false;
  };
  bool bounds_another(temporal::NodeIndex node) const;
  /// Shortest distances from `from`; `beyond` selects the edges of a node at a given distance.
  template <class Beyond>
  std::vector<temporal::Ticks> distances(temporal::NodeIndex from, Beyond&& beyond) const;

  std::vector<std::vector<Edge>> out_;
  std::vector<bool> is_past_;
};

}  // namespace skein::supervisor
