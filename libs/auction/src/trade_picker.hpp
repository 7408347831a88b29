// SPDX-License-Identifier: Apache-2.0
// Chooses the tasks of a trade and the members that are called for it.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "draft.hpp"
#include "skein/auction/auctioneer.hpp"
#include "skein/foundation/random.hpp"

namespace skein::auction {

/// Chooses tasks near each other, since those can be exchanged with gain. With a probability of
/// half the aim's equity the first of them belongs to the route that ends last. Source: Shaw 1998
/// (relatedness).
class TradePicker {
 public:
  TradePicker(const Catalogue& catalogue, Aim aim, const SaleLimits& limits, std::uint64_t seed);

  /// At most max(2, `limits.trade`) tasks, beginning with those of `first` (as many as
  /// `limits.trade`); the others are drawn from the tasks that are not fixed. Empty: there are
  /// none.
  std::vector<TaskNumber> items(const std::vector<BookedRoute>& books, std::size_t last_to_end,
                                const std::vector<TaskNumber>& first);
  /// Indexes of the routes to call, about `limits.called`: the owners of the items, then the owners
  /// of the tasks nearest to an item, and one at random.
  std::set<std::size_t> called(const std::vector<BookedRoute>& books,
                               const std::vector<TaskNumber>& items);
  Random& random() { return random_; }

 private:
  double distance(TaskNumber one, TaskNumber other) const;
  TaskNumber near(const std::vector<TaskNumber>& chosen, std::vector<TaskNumber>& left);

  const Catalogue* catalogue_;
  Aim aim_;
  SaleLimits limits_;
  Random random_;
};

}  // namespace skein::auction
