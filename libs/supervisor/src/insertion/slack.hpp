// SPDX-License-Identifier: Apache-2.0
// Shortening of durations that are given as ranges, so that an order becomes feasible.
#pragma once

#include <vector>

#include "insertion/judge.hpp"

namespace skein::supervisor {

/// The durations in an order that are given as ranges ("60..120"). All are shortened by the same
/// share of their range.
class Slack {
 public:
  Slack(const Goals& order, const mission::Vocabulary& vocabulary);

  /// No duration is a range.
  bool none() const { return ranges_.empty(); }
  /// The order with numbers in place of ranges: the longest durations at `share` 0, the shortest at
  /// kAll.
  Goals goals(int share) const;
  /// The durations that are shorter than their maxima at `share`.
  std::vector<Shortened> shortened(int share) const;

  /// The least share at which durations are shorter by kSpare than at `share`, on average; at most
  /// kAll.
  int with_some_to_spare(int share) const;

  static constexpr int kAll = 64;
  /// Margin per duration, so that a start that is late by as much violates no constraint [s].
  static constexpr double kSpare = 5;

 private:
  struct Range {
    std::size_t goal = 0, argument = 0;
    mission::DurationRange range;
    double at(int share) const;  ///< [s]
  };
  Goals order_;
  std::vector<Range> ranges_;
};

}  // namespace skein::supervisor
