// SPDX-License-Identifier: Apache-2.0
// Makes a dispatchable network smaller.
#pragma once

#include <vector>

#include "skein/temporal/dispatchable_network.hpp"

namespace skein::temporal {

/// Leaves out an edge when two others say as much in a way the executor sees: a negative edge when
/// two negative ones do, another when any edge followed by one that is not negative says more. What
/// replaces an edge is shorter, or as short and over nodes in between, so all can be left out at
/// once. Precondition: edges ordered by (from, to), one for each pair, without a negative cycle.
/// O(n³).
std::vector<DistanceEdge> without_implied_edges(const std::vector<DistanceEdge>& edges,
                                                std::size_t nodes);

}  // namespace skein::temporal
