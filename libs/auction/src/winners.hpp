// SPDX-License-Identifier: Apache-2.0
// Winner determination: which items go where, all offers on the table.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "draft.hpp"
#include "skein/foundation/random.hpp"

namespace skein::auction {

/// An item as it was sold, and what the next best group would have made of it at that moment.
struct Decided {
  Placing placing;
  std::optional<Placing> next_best;
};

/// Tries several orders of sale and leaves in the draft the best found: all orders of at most three
/// items; of more, the one with most to lose first, the cheapest first, and random orders. Items
/// that no order could place stay out. Source: Koenig 2008 (regret); notes, team 2.
std::vector<Decided> determine_winners(Draft& draft, Random& random, std::size_t orders);

}  // namespace skein::auction
