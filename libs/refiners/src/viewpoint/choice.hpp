// SPDX-License-Identifier: Apache-2.0
// Several view points that go together.
#pragma once

#include <optional>
#include <vector>

#include "viewpoint/search.hpp"

namespace skein::refiners {

/// As many places as the query asks for, or as there are, best first, apart from each other as it
/// asks. Each is the best that is apart from those before it; when that leaves room for fewer than
/// could be, the azimuths are chosen together instead.
std::vector<Found> choose(ViewpointSearch& search, const ViewpointField& field,
                          const Countdown& countdown);

/// Of utilities around a circle (nothing: no place), the indices of `count` that are at least
/// `gap` apart, or of as many as there are, with the greatest sum. Cost: O(slots² × count).
std::vector<std::size_t> choose_around(const std::vector<std::optional<double>>& utilities,
                                       std::size_t gap, std::size_t count);

}  // namespace skein::refiners
