// SPDX-License-Identifier: Apache-2.0
// The possible sweeps of an area, as gates of a stop in a tour.
#pragma once

#include <vector>

#include "skein/refiners/coverage.hpp"
#include "skein/refiners/tour.hpp"

namespace skein::refiners {

/// Most corners of an area at which sweeps begin; of more corners this many are chosen, spread
/// around the border.
inline constexpr std::size_t kMostEntries = 8;

/// Sweeps of the area that begin near each of its corners, as gates (entry, exit and expected
/// duration of the sweep), without duplicates. Ignores `query.start` and `query.end`.
/// Cost: one sweep for each corner.
Result<std::vector<Gate>, Refusal> gates_of(const CoverageQuery& query, const Setting& setting);

}  // namespace skein::refiners
