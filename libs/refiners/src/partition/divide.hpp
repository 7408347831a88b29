// SPDX-License-Identifier: Apache-2.0
// The division of a convex polygon, with the anchors used.
#pragma once

#include <vector>

#include "skein/refiners/budget.hpp"
#include "skein/world/geometry.hpp"

namespace skein::refiners::partition {

struct Division {
  std::vector<world::Polygon> parts;    ///< as divide() gives them
  std::vector<world::Vector2> anchors;  ///< the anchor used for each part
};

/// Like divide(), but up to `most` divisions, the most compact first; at least one, or none if the
/// time of the budget was up before one of many pieces was found. For more than four anchors only
/// one division. `between` (0, 1): position chosen within each range of possible cuts.
std::vector<Division> divisions(const world::Polygon& area,
                                const std::vector<world::Vector2>& anchors,
                                const std::vector<double>& shares, std::size_t most,
                                const Budget& budget = {}, double between = 0.5);

}  // namespace skein::refiners::partition
