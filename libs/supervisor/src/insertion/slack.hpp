// SPDX-License-Identifier: Apache-2.0
// What high-level tasks may give of their durations, so that an order can be kept to.
#pragma once

#include <vector>

#include "insertion/judge.hpp"

namespace skein::supervisor {

/// The durations in an order that are given as ranges ("60..120"). Each gives the same part of what
/// it may give.
class Slack {
 public:
  Slack(const Goals& order, const mission::Vocabulary& vocabulary);

  /// No duration may be shorter.
  bool none() const { return ranges_.empty(); }
  /// The order with durations of figures: at `share` 0 the longest, at kAll the shortest.
  Goals goals(int share) const;
  /// What becomes of each that is shorter than its most.
  std::vector<Shortened> shortened(int share) const;

  /// The least share with which each gives kSpare more than with `share`, on average; kAll at most.
  int with_some_to_spare(int share) const;

  static constexpr int kAll = 64;
  /// What starts so much late breaks nothing [s].
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
