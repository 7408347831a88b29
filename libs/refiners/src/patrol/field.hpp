// SPDX-License-Identifier: Apache-2.0
// The ground to be patrolled, and the short tracks from which all of it is perceived.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/sight.hpp"
#include "patrol/space.hpp"

namespace skein::refiners {

/// The cells of a patrol. Immutable.
struct PatrolField {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<std::size_t> cells;   ///< of the grid, in its order: that can be perceived
  std::vector<double> risk;         ///< of each of them, >= the least risk
  std::vector<std::uint32_t> slot;  ///< per cell of the grid: its place in `cells`, or kNone
  std::vector<bool> open;           ///< per cell of the grid: the vehicle may be over its centre
  std::size_t hidden = 0;           ///< cells of the zone that cannot be perceived
  double total_risk = 0;
};

/// A piece of a lane: flown from one end to the other, either way, it perceives its cells.
struct PatrolBlock {
  std::vector<world::Vector2> track;  ///< at least one point; every segment is open
  std::vector<std::uint32_t> cells;   ///< places in PatrolField::cells; each is of one block only
  double heading = 0;                 ///< along the track [rad]; of its lane for a single point
  double length = 0;                  ///< of the track [m]
  std::size_t lane = 0;               ///< lanes count across; blocks of one are in order along it
};

/// What the blocks of a vehicle may be like.
struct PatrolLayout {
  bool straight = false;           ///< tracks without a bend, for what cannot hover
  std::size_t most_blocks = 1024;  ///< longer pieces are made to keep to about that
};

/// Cells of the zone whose centre is perceived from over the centre of an open cell (or its own).
/// A risk below `least` counts as `least`. What is made when the deadline of the sight has passed
/// is not whole.
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

/// Leaves only the cells and blocks that `keep` says; what is left out counts as hidden.
void leave_only(PatrolField& field, std::vector<PatrolBlock>& blocks,
                const std::vector<bool>& keep);

}  // namespace skein::refiners
