// SPDX-License-Identifier: Apache-2.0
// In which order and sense to fly the lanes of one block.
#pragma once

#include <cstdint>
#include <vector>

#include "coverage/sweep_lanes.hpp"
#include "coverage/turn_model.hpp"

namespace skein::refiners {

/// An order of the lanes of a block, by their indices.
using LaneOrder = std::vector<std::uint32_t>;

/// One way of flying all the lanes of a block: every next one in the opposite sense.
struct BlockOption {
  std::uint32_t order = 0;  ///< index into BlockOptions::orders
  bool along = true;        ///< the first lane of that order is flown along x
  bool backwards = false;   ///< all of it turned round, the last lane first
  double seconds = 0;       ///< lanes, and turns between them
  Pass first, last;
};

struct BlockOptions {
  std::vector<LaneOrder> orders;
  std::vector<BlockOption> options;
};

/// One lane after its neighbour, from either side, first in either sense; and for a vehicle whose
/// turns are wider than the lanes, the least slow of the orders that skip lanes, which its U-turns
/// then lead back to. Never empty. Precondition: the block has lanes.
BlockOptions options_of(const Block& block, const TurnModel& model);

/// Seconds of a block if all of its lanes ended level: what its options take more comes from ends
/// that are not. Cost: O(lanes).
double level_seconds(const Block& block, const TurnModel& model);

/// The lanes of a block as an option has them flown.
std::vector<Pass> passes_of(const Block& block, const BlockOptions& options,
                            const BlockOption& option);

/// `lanes` in rounds: the first half of each interleaved with its second half, so that turns lead
/// over half a round, or one lane less or more.
LaneOrder interleaved(std::size_t lanes, std::size_t rounds);

}  // namespace skein::refiners
