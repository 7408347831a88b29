// SPDX-License-Identifier: Apache-2.0
// In which order to sweep the blocks that a region was cut into.
#pragma once

#include <optional>
#include <vector>

#include "coverage/lane_order.hpp"

namespace skein::refiners {

/// Where the vehicle comes from and goes to, in the sweep frame.
struct SweepEnds {
  std::optional<world::Vector2> start, end;
};

struct Route {
  std::vector<Pass> passes;  ///< in the sweep frame, in the order flown
  double seconds = 0;        ///< with the ways from the start and to the end
};

/// Seconds of the least slow route found. One block: the least slow of its options; up to eight:
/// the least slow of all orders and options; more: the nearest next, then each moved to where it
/// costs least. Precondition: at least one block, none empty.
Route order_blocks(const std::vector<Block>& blocks, const TurnModel& model, const SweepEnds& ends);

/// Seconds of such a route, or a little more: of many blocks only the nearest next is tried.
double quick_seconds(const std::vector<Block>& blocks, const TurnModel& model,
                     const SweepEnds& ends);

}  // namespace skein::refiners
