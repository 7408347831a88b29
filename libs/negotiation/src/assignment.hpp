// SPDX-License-Identifier: Apache-2.0
// Who plays which role for the least cost together.
#pragma once

#include <optional>
#include <vector>

#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// Of each UAV the column that it is given.
using Assignment = std::vector<std::size_t>;

/// Every row (UAV) is given one column (role), each column within its arity, for the least sum of
/// costs; absent: impossible. `costs[row][column]` absent: that row cannot. Of equal sums, the
/// first in the order of columns, rows from the first on. Exact. Cost: O(rows × columns × number of
/// ways to have so many in each column).
std::optional<Assignment> assign(const std::vector<std::vector<std::optional<double>>>& costs,
                                 const std::vector<Arity>& arities);

}  // namespace skein::interaction
