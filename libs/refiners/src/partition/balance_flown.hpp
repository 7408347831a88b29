// SPDX-License-Identifier: Apache-2.0
// Of divisions that coverage balances, one whose parts are flown in about the same time.
#pragma once

#include <vector>

#include "partition/track.hpp"

namespace skein::refiners::partition {

/// `best`, or one of those that were planned, or one like those: as they are flown in thought, some
/// dozens of sweeps of each member. `best` as it is where what is flown is not known.
/// Precondition: planner.flies().
Trial balance_flown(Planner& planner, Trial best, std::vector<Track> tracks,
                    std::vector<Trial> planned);

}  // namespace skein::refiners::partition
