// SPDX-License-Identifier: Apache-2.0
// Dispatchable form of an STNU: execution decisions need only the neighbours of a node.
#pragma once

#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/temporal/stnu_fault.hpp"

namespace skein::temporal {

/// to - from <= weight, whatever nature does.
struct DistanceEdge {
  NodeIndex from = 0;
  NodeIndex to = 0;
  Ticks weight = 0;
  bool operator==(const DistanceEdge&) const = default;
};

/// `node` comes no earlier than `delay` after the activation of contingent link `link`, unless the
/// link's end has come. delay > 0.
struct WaitEdge {
  NodeIndex node = 0;
  std::uint32_t link = 0;
  Ticks delay = 0;
  bool operator==(const WaitEdge&) const = default;
};

/// An extended STNU (ordinary and wait edges) in dispatchable form. Every run of a real-time
/// executor on it keeps every requirement, whatever durations nature chooses inside the contingent
/// bounds.
struct DispatchableNetwork {
  Stnu plan;                        ///< the original network, with the same contingent indices
  std::vector<DistanceEdge> edges;  ///< ordered by (from, to), one for each pair
  std::vector<WaitEdge> waits;      ///< ordered by (node, link), one for each pair
  bool operator==(const DispatchableNetwork&) const = default;
};

/// Execution begins with the origin: the requirement that no node comes before it is added.
/// Cost: O(n³) time at worst, O(n²) memory at worst; edges that others imply are left out where
/// that is cheap to see. Errors: what `find_fault` finds, kContingentOrigin, kNotControllable,
/// kOverflow. Source: spec 5.2; Morris 2014; Hunsberger, Posenato 2024 (dispatchability of STNUs).
Result<DispatchableNetwork, StnuError> make_dispatchable(const Stnu& network);

}  // namespace skein::temporal
