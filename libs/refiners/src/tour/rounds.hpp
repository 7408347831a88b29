// SPDX-License-Identifier: Apache-2.0
// Ordering of a tour with lazily planned paths; private.
#pragma once

#include <optional>

#include "tour/legs.hpp"

namespace skein::refiners {

/// Solves the ordering problem with lower bounds as costs, plans the paths that the order uses,
/// replaces their bounds by real costs, and solves again, until the real cost of an order equals
/// its cost in the problem. With an exact solver that order is optimal, whatever the unplanned
/// paths would cost. After kMostTourRounds rounds, and for the rest of the time or steps, orders
/// over the known paths.
class TourRounds {
 public:
  TourRounds(TourLegs& legs, const Setting& setting);

  /// The best order with all paths known, with the effort of all rounds; nothing: none was found.
  std::optional<TourOrder> run();

 private:
  enum class Next : std::uint8_t { kGoOn, kSettled, kStop };

  Next round();
  void finish(bool settled);
  TourOrder solve(const TourProblem& problem, std::uint64_t most_steps);
  /// Steps of the next round: enough for the exact search if `thorough_`, else only a quick one.
  std::uint64_t steps_of_round() const;
  std::uint64_t steps_left() const;
  bool has_bounds() const;
  /// Keeps the order as the best one if its real cost is known and lower.
  void keep(TourOrder order);

  TourLegs& legs_;
  const Setting& setting_;
  bool started_ = false;          // there was time to
  std::uint64_t exact_sets_ = 0;  // 0: the exact search is never made
  bool thorough_ = true;          // exact where it can be
  std::optional<TourOrder> best_;
  Effort effort_;
};

}  // namespace skein::refiners
