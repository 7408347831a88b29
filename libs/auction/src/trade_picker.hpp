// SPDX-License-Identifier: Apache-2.0
// What is put back on sale together, and who is asked.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "draft.hpp"
#include "skein/auction/auctioneer.hpp"
#include "skein/foundation/random.hpp"

namespace skein::auction {

/// Tasks near each other, more often of who ends last where that counts: what could be exchanged.
/// Source: Shaw 1998 (relatedness).
class TradePicker {
 public:
  TradePicker(const Catalogue& catalogue, Aim aim, const SaleLimits& limits, std::uint64_t seed);

  /// At most `limits.trade` tasks that may move, none if there are none; `first` are among them.
  std::vector<TaskNumber> items(const std::vector<BookedRoute>& books, std::size_t last_to_end,
                                const std::vector<TaskNumber>& first);
  /// Indexes of routes: owners of the items, then owners of what lies near, then by chance.
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
