// SPDX-License-Identifier: Apache-2.0
// The order of a tour whose ways are looked for as they are needed; private.
#pragma once

#include <optional>

#include "tour/legs.hpp"

namespace skein::refiners {

/// Solves with costs that are never too high, looks for the ways that the order found uses, puts in
/// what they really take, and solves again: until an order costs no more than it was found with.
/// That one is the best of all when the solver is exact, whatever the ways not looked for would
/// take. At most kMostTourRounds; what comes first, and the rest of the time of a clock, or of the
/// steps, goes into an order over the ways that are known by then.
class TourRounds {
 public:
  TourRounds(TourLegs& legs, const Setting& setting);

  /// The best order whose ways are all known; nothing when none was found. Its effort is that of
  /// all rounds.
  std::optional<TourOrder> run();

 private:
  enum class Next : std::uint8_t { kGoOn, kSettled, kStop };

  Next round();
  void finish(bool settled);
  TourOrder solve(const TourProblem& problem, std::uint64_t most_steps);
  /// Of the next search: a quick one, or also the exact one where it takes long.
  std::uint64_t steps_of_round() const;
  std::uint64_t steps_left() const;
  bool has_bounds() const;
  /// What an order really takes, when that is known.
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
