// SPDX-License-Identifier: Apache-2.0
// The shortest free path through one station of each layer.
#pragma once

#include <vector>

#include "flyable/leg.hpp"
#include "flyable/stations.hpp"

namespace skein::refiners {

struct StationSearch {
  std::size_t most_skipped = 0;  ///< layers that one leg may leave out
  bool thorough = false;         ///< as FlyableLegs::leg takes it
};

struct FoundWay {
  Way way;                   ///< empty: none
  std::size_t furthest = 0;  ///< layer reached
};

/// Lazy A*: a leg is computed and checked only when it is the most promising one; the heuristic is
/// the lower bound on the remaining legs.
FoundWay search_stations(const std::vector<StationLayer>& layers, FlyableLegs& legs,
                         const StationSearch& search);

}  // namespace skein::refiners
