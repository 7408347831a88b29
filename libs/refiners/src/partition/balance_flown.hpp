// SPDX-License-Identifier: Apache-2.0
// Refines a balanced division by the durations of real flight.
#pragma once

#include <vector>

#include "partition/track.hpp"

namespace skein::refiners::partition {

/// Returns `best` or a similar division that is better balanced by the durations of real flight
/// (FlownSweep), after some dozens of sweeps of each member; `best` unchanged if those are unknown.
/// Precondition: planner.flies().
Trial balance_flown(Planner& planner, Trial best, std::vector<Track> tracks,
                    std::vector<Trial> planned);

}  // namespace skein::refiners::partition
