// SPDX-License-Identifier: Apache-2.0
// Assignment of roles to UAVs at least total cost.
#pragma once

#include <optional>
#include <vector>

#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// The column (role) of each row (UAV).
using Assignment = std::vector<std::size_t>;

/// Assigns one column (role) to every row (UAV), within the arities of the columns, at the least
/// sum of costs; absent: impossible. `costs[row][column]` absent: the row cannot have the column.
/// Of equal sums, the lexicographically first. Exact. Cost: O(rows × columns × number of ways to
/// fill the columns).
std::optional<Assignment> assign(const std::vector<std::vector<std::optional<double>>>& costs,
                                 const std::vector<Arity>& arities);

}  // namespace skein::interaction
