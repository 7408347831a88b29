// SPDX-License-Identifier: Apache-2.0
// The valid name that a wrong one most likely meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace skein {

/// The candidate at the smallest edit distance (insert, delete, replace, swap of neighbours; case
/// does not count), the first among equals; empty when none is within half of the name's
/// length, rounded up. Cost: O(candidates × lengths).
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// "; did you mean 'nearest'?", to end a message about a wrong name with; empty without a nearest.
std::string did_you_mean(const std::string& nearest);

}  // namespace skein
