// SPDX-License-Identifier: Apache-2.0
// Any-angle path search between voxel centres.
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

/// Speeds up the search, at the price of slightly longer paths.
struct AnyAngleHelp {
  double greed = 1;                 ///< weight of the heuristic (straight distance left), >= 1
  GraphDistances* known = nullptr;  ///< distances of a graph search between the same voxels; the
                                    ///< search then runs from the goal and avoids known dead ends
};

/// A good path, not the best one, of straight legs between voxel centres: A* over the 26
/// neighbours, in which the parent of a node is the last corner with line of sight to it (Lazy
/// Theta*, Nash, Koenig and Tovey 2010). Unlike the facet graph it does not distort lengths by
/// direction. Nodes with an estimated total cost of `bound` [m × cost] or more are not expanded.
/// Memory: 8 bytes for each voxel of the blocks of 8³ that are reached.
AnyAngleWay search_any_angle(const world::Airspace& airspace, const world::Voxel& from,
                             const world::Voxel& to, double bound, const Budget& budget,
                             const AnyAngleHelp& help = {});

}  // namespace skein::refiners
