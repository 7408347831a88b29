// SPDX-License-Identifier: Apache-2.0
// viewshed: what of the ground is seen from a place.
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
  double height = 0;                                       ///< over the ground, of what is seen [m]
  double range = std::numeric_limits<double>::infinity();  ///< of sight, in space [m], > 0
  double cell = 0;        ///< side of the raster's cells [m]; 0: the terrain's
  world::Polygon area{};  ///< only cells whose middle is in it; empty: all ground that is known
};

enum class Sight : std::uint8_t {
  kHidden,
  kSeen,
  kLeftOut,  ///< of the question
};

struct Viewshed {
  world::Grid grid;  ///< over the area, or the whole terrain
  std::vector<Sight> cells;
  std::size_t seen = 0, asked = 0;  ///< cells; asked >= seen
};

/// Refined cost: the part of the cells asked that is hidden. Steps of the budget: cells. A cell is
/// seen when a point over its middle is, exactly for the bilinear ground.
/// Refused: figures that make no sense, more than kMostSightCells cells, an area over which no
/// middle of a cell lies (kBadQuery); a place in the ground (kBlocked); kBudgetExhausted, since a
/// part of it says nothing of the rest. Cost: O(cells × cells on the way).
Outcome<Viewshed> refine(const ViewshedQuery& query, const Setting& setting);

inline constexpr double kMostSightCells = 4e6;

}  // namespace skein::refiners
