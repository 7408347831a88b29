// SPDX-License-Identifier: Apache-2.0
// The division of a convex polygon, with what became of each anchor.
#pragma once

#include <vector>

#include "skein/refiners/budget.hpp"
#include "skein/world/geometry.hpp"

namespace skein::refiners::partition {

struct Division {
  std::vector<world::Polygon> parts;    ///< as divide() gives them
  std::vector<world::Vector2> anchors;  ///< what each part was anchored at
};

/// As divide(), but up to `most` ways to do it, the most compact parts first; at least one, or none
/// when the time of the budget was up before one of many pieces was found. More than four anchors
/// are divided in one way only. `between` (0, 1): which of the cuts that could be turned are taken.
std::vector<Division> divisions(const world::Polygon& area,
                                const std::vector<world::Vector2>& anchors,
                                const std::vector<double>& shares, std::size_t most,
                                const Budget& budget = {}, double between = 0.5);

}  // namespace skein::refiners::partition
