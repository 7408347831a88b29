// SPDX-License-Identifier: Apache-2.0
// The independent oracle: Bellman–Ford on a whole network, from scratch, sharing nothing with the
// engine.
#pragma once

#include <cstddef>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Earliest and latest date of a node, or the interval that two nodes' distance may take.
struct ReferenceWindow {
  Ticks min = kMinusInfinite;
  Ticks max = kInfinite;
  bool operator==(const ReferenceWindow&) const = default;
};

/// What a network allows. `windows` has one entry per node if consistent, none otherwise.
struct ReferenceSolution {
  bool consistent = false;
  std::vector<ReferenceWindow> windows;
  bool operator==(const ReferenceSolution&) const = default;
};

/// Consistent: some assignment satisfies all arcs (also of nodes that v0, of position 0, does not
/// bound). `nodes` counts v0. Cost: O(nodes × arcs).
ReferenceSolution solve_reference(std::size_t nodes, const std::vector<Arc>& arcs);
ReferenceSolution solve_reference(const Mastn& mastn);

/// The tightest [min, max] for `to` - `from` that all the arcs imply together.
/// Precondition: the network is consistent. Cost: as solve_reference.
ReferenceWindow implied_interval(std::size_t nodes, const std::vector<Arc>& arcs, NodeIndex from,
                                 NodeIndex to);

}  // namespace skein::temporal
