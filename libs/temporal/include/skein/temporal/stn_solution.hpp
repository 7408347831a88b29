// SPDX-License-Identifier: Apache-2.0
// A simple temporal network solved once, from scratch; for what changes see stn_engine.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/temporal/date_window.hpp"
#include "skein/temporal/network.hpp"
#include "skein/temporal/stn_engine.hpp"

namespace skein::temporal {

struct StnSolution {
  bool consistent = false;
  std::vector<DateWindow> windows;    ///< of each node; empty unless consistent
  std::vector<ConflictArc> conflict;  ///< a negative cycle, in order; empty iff consistent
  std::uint64_t checks = 0;           ///< evaluations of one difference constraint
};

/// Consistency, and the dates or a negative cycle. Any arcs: several between two nodes, from a node
/// to itself (which hold iff 0 is in them), with min > max. ConflictArc::arc is a position in
/// `arcs`. Errors: kUnknownNode and kOverflow.
///
/// First a schedule that keeps every constraint, by Bellman–Ford with alternating sweeps (Yen) in
/// an order in which minima lead forward: minima are settled by one sweep, maxima by the next one
/// back, and only a chain of bounds that goes to and fro needs more. With it as a potential the
/// earliest and the latest dates are two searches by Dijkstra's algorithm: how wide a network is
/// does not matter, as it does to a queue. Cost: O(m log n) after the sweeps, of which plans need
/// few; O(n m) at worst. Memory: about 100 bytes an arc.
Result<StnSolution, StnRefusal> solve_stn(const Stn& network);

}  // namespace skein::temporal
