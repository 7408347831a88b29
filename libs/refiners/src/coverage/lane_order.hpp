// SPDX-License-Identifier: Apache-2.0
// Order and direction of the lanes of one block.
#pragma once

#include <cstdint>
#include <vector>

#include "coverage/sweep_lanes.hpp"
#include "coverage/turn_model.hpp"

namespace skein::refiners {

/// An order of the lanes of a block, by their indices.
using LaneOrder = std::vector<std::uint32_t>;

/// One sequence of all lanes of a block, flown in alternating directions.
struct BlockOption {
  std::uint32_t order = 0;  ///< index into BlockOptions::orders
  bool along = true;        ///< the first lane of the order is flown along x
  bool backwards = false;   ///< the whole sequence is reversed, the last lane first
  double seconds = 0;       ///< lanes, and turns between them
  Pass first, last;
};

struct BlockOptions {
  std::vector<LaneOrder> orders;
  std::vector<BlockOption> options;
};

/// Lanes side by side, from either side, with the first in either direction; and for a vehicle
/// whose turns are wider than the lanes also the fastest order that skips lanes and returns to them
/// by U-turns. Never empty. Precondition: the block has lanes.
BlockOptions options_of(const Block& block, const TurnModel& model);

/// Duration [s] of a block if the ends of its lanes were aligned; its options take longer because
/// of ends that are not. Cost: O(lanes).
double level_seconds(const Block& block, const TurnModel& model);

/// The lanes of a block as flown by an option.
std::vector<Pass> passes_of(const Block& block, const BlockOptions& options,
                            const BlockOption& option);

/// An order of `lanes` in rounds: the first half of each round interleaved with its second half, so
/// that each turn spans half a round, plus or minus one lane.
LaneOrder interleaved(std::size_t lanes, std::size_t rounds);

}  // namespace skein::refiners
