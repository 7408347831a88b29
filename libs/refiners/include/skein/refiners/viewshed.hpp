// SPDX-License-Identifier: Apache-2.0
// viewshed: the part of the ground that is visible from a place.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "skein/refiners/refinement.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/geometry.hpp"
#include "skein/world/grid.hpp"

namespace skein::refiners {

struct ViewshedQuery {
  world::Vector3 from = world::Vector3::Zero();            ///< [m], ENU; over the ground
  double height = 0;                                       ///< of the targets over the ground [m]
  double range = std::numeric_limits<double>::infinity();  ///< of sight, in space [m], > 0
  double cell = 0;        ///< side of the raster's cells [m]; 0: that of the terrain's cells
  world::Polygon area{};  ///< only cells with their centre in it count; empty: the whole terrain
};

enum class Sight : std::uint8_t {
  kHidden,
  kSeen,
  kLeftOut,  ///< not in the area of the query
};

struct Viewshed {
  world::Grid grid;  ///< over the area, or the whole terrain
  std::vector<Sight> cells;
  std::size_t seen = 0, asked = 0;  ///< numbers of visible cells, and of cells in the area
};

/// A cell is visible if the point `height` over its centre is, computed exactly for the bilinear
/// ground. Refined cost: the hidden fraction of the cells in the area. Steps of the budget: cells.
/// Refused: invalid figures, more than kMostSightCells cells, an area without the centre of a cell
/// (kBadQuery); a place in the ground (kBlocked); kBudgetExhausted, without a partial result.
/// Cost: O(cells × cells crossed by a line of sight).
Outcome<Viewshed> refine(const ViewshedQuery& query, const Setting& setting);

inline constexpr double kMostSightCells = 4e6;

}  // namespace skein::refiners
