// SPDX-License-Identifier: Apache-2.0
// Winner determination: assigns the items of a round from all offers.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "draft.hpp"
#include "skein/foundation/random.hpp"

namespace skein::auction {

/// The placing of a sold item, and that of the next best group at the same moment.
struct Decided {
  Placing placing;
  std::optional<Placing> next_best;
};

/// Greedy insertion in several orders of the items; leaves the best result in the draft. At most
/// three items: all orders; more: by largest regret, by lowest price, and in
/// `orders` random orders. Items that cannot be placed stay out. Source: Koenig 2008 (regret);
/// notes, team 2.
std::vector<Decided> determine_winners(Draft& draft, Random& random, std::size_t orders);

}  // namespace skein::auction
