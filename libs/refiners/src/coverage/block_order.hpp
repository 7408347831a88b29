// SPDX-License-Identifier: Apache-2.0
// Order of the blocks that a region was cut into.
#pragma once

#include <optional>
#include <vector>

#include "coverage/lane_order.hpp"

namespace skein::refiners {

/// Positions of the vehicle before and after the sweep, in the sweep frame.
struct SweepEnds {
  std::optional<world::Vector2> start, end;
};

struct Route {
  std::vector<Pass> passes;  ///< in the sweep frame, in the order flown
  double seconds = 0;        ///< including the legs from the start and to the end
};

/// The fastest route found. One block: the fastest of its options; up to eight: the fastest of all
/// orders and options; more: nearest neighbour, then each block moved to its cheapest position.
/// Precondition: at least one block, none empty.
Route order_blocks(const std::vector<Block>& blocks, const TurnModel& model, const SweepEnds& ends);

/// An upper estimate of the duration of that route [s]: of many blocks only by nearest neighbour.
double quick_seconds(const std::vector<Block>& blocks, const TurnModel& model,
                     const SweepEnds& ends);

}  // namespace skein::refiners
