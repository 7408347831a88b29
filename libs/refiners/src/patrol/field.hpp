// SPDX-License-Identifier: Apache-2.0
// The cells of a patrol, and short tracks from which all of them are perceived.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/sight.hpp"
#include "patrol/space.hpp"

namespace skein::refiners {

/// The cells of a patrol. Immutable.
struct PatrolField {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<std::size_t> cells;   ///< perceivable cells of the grid, ascending
  std::vector<double> risk;         ///< of each of `cells`, >= the least risk
  std::vector<std::uint32_t> slot;  ///< per cell of the grid: its index in `cells`, or kNone
  std::vector<bool> open;           ///< per cell of the grid: the vehicle may be over its centre
  std::size_t hidden = 0;           ///< cells of the zone that cannot be perceived
  double total_risk = 0;
};

/// A piece of a lane. The vehicle perceives all its cells by flying it in either direction.
struct PatrolBlock {
  std::vector<world::Vector2> track;  ///< at least one point; every segment is open
  std::vector<std::uint32_t> cells;   ///< places in PatrolField::cells; each is of one block only
  double heading = 0;                 ///< along the track [rad]; of its lane for a single point
  double length = 0;                  ///< of the track [m]
  std::size_t lane = 0;               ///< lanes count across; blocks of one are in order along it
};

/// Constraints on the blocks.
struct PatrolLayout {
  bool straight = false;           ///< tracks without bends, for vehicles that cannot hover
  std::size_t most_blocks = 1024;  ///< approximate limit, kept by longer pieces
};

/// Cells of the zone whose centre is perceived from over the centre of an open cell (or its own).
/// A risk below `least` counts as `least`. The result is incomplete if the deadline of the sight
/// has passed.
PatrolField make_patrol_field(const PatrolSpace& space, const PatrolSight& sight,
                              const world::Polygon& zone, const std::vector<double>& risk,
                              double least);

/// Lanes along the grid, in the direction that needs fewer of them, each perceiving as many rows as
/// the footprint surely reaches; cut into pieces about as long as they are wide. Cells that no lane
/// perceives (next to slanted borders and closed volumes) get points of their own. Every cell of
/// the field is of exactly one block, and perceived along its track, unless the deadline of the
/// sight has passed.
std::vector<PatrolBlock> make_patrol_blocks(const PatrolField& field, const PatrolSpace& space,
                                            const PatrolSight& sight, const PatrolLayout& layout);

/// Keeps only the blocks marked in `keep`, and their cells; other cells count as hidden.
void leave_only(PatrolField& field, std::vector<PatrolBlock>& blocks,
                const std::vector<bool>& keep);

}  // namespace skein::refiners
