// SPDX-License-Identifier: Apache-2.0
// Selection of several view points that keep their distances.
#pragma once

#include <optional>
#include <vector>

#include "viewpoint/search.hpp"

namespace skein::refiners {

/// Up to `count` places of the query with the required distances, best first. Greedy: each is the
/// best that is apart from those before it; if fewer are found than possible, the azimuths are
/// chosen jointly instead.
std::vector<Found> choose(ViewpointSearch& search, const ViewpointField& field,
                          const Countdown& countdown);

/// Selects from utilities around a circle (nothing: no place) the indices of `count` slots, or as
/// many as possible, at least `gap` apart and with the greatest sum. Cost: O(slots² × count).
std::vector<std::size_t> choose_around(const std::vector<std::optional<double>>& utilities,
                                       std::size_t gap, std::size_t count);

}  // namespace skein::refiners
