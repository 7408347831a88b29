// SPDX-License-Identifier: Apache-2.0
// The ways an area may be swept, as the gates of a stop.
#pragma once

#include <vector>

#include "skein/refiners/coverage.hpp"
#include "skein/refiners/tour.hpp"

namespace skein::refiners {

/// Most corners of an area at which sweeps begin; of more, so many are chosen all around it.
inline constexpr std::size_t kMostEntries = 8;

/// Sweeps of the area that begin near each of its corners, as gates (entry, exit and expected
/// duration of the sweep); the same gate only once. `query.start` and `query.end` do not count.
/// Cost: one sweep for each corner.
Result<std::vector<Gate>, Refusal> gates_of(const CoverageQuery& query, const Setting& setting);

}  // namespace skein::refiners
