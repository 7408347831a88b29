// SPDX-License-Identifier: Apache-2.0
// Ways between voxel centres whose legs have any direction.
#pragma once

#include <cstdint>

#include "path/facet_search.hpp"
#include "skein/refiners/budget.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

struct AnyAngleWay {
  Way way;  ///< empty when none was found that costs less than `bound`
  std::uint64_t expanded = 0;
  bool cut_short = false;  ///< by the clock
};

/// What makes the search shorter, at the price of ways that are a little longer.
struct AnyAngleHelp {
  double greed = 1;                 ///< what the straight distance left counts, >= 1
  GraphDistances* known = nullptr;  ///< of a search of the graph between the same two: searched
                                    ///< from the goal, so that dead ends are not looked into again
};

/// A good way, not the best one: among straight legs between voxel centres, found by A* over the 26
/// neighbours where each node hangs on the last corner that sees it (Lazy Theta*, Nash, Koenig and
/// Tovey 2010). The facet graph measures lengths by its own directions, so its best way can pass on
/// the wrong side of things; this one has no such grain. Looks at nothing from which
/// it is estimated at `bound` [m × cost] or more. Memory: 8 bytes for each voxel of the blocks of
/// 8³ that are reached.
AnyAngleWay search_any_angle(const world::Airspace& airspace, const world::Voxel& from,
                             const world::Voxel& to, double bound, const Budget& budget,
                             const AnyAngleHelp& help = {});

}  // namespace skein::refiners
