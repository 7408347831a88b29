// SPDX-License-Identifier: Apache-2.0
// The dates that windows, durations and precedences leave to the tasks of a lot, whoever does them.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/auction/catalogue.hpp"

namespace skein::auction {

/// Longest chains of precedences from each beginning and back from each deadline. Ways between
/// places count as nothing. Cost: linear in tasks and precedences.
class Chains {
 public:
  /// `catalogue` outlives it.
  explicit Chains(const Catalogue& catalogue);

  /// Whether the task is on a cycle of precedences or after one. It then has no dates.
  bool stuck(std::uint32_t task) const { return waiting_[task] > 0; }
  double earliest_end(std::uint32_t task) const { return end_[task]; }
  /// So that it and all that comes after it can keep their deadlines [s].
  double latest_end(std::uint32_t task) const { return latest_[task]; }
  bool late(std::uint32_t task) const {
    return !stuck(task) && end_[task] > catalogue_->task(task).deadline;
  }
  /// Whether all tasks have dates that keep their deadlines.
  bool hold() const;
  /// The tasks that give `task` its earliest end, in their order; `task` is the last.
  std::vector<std::uint32_t> leading_to(std::uint32_t task) const;
  /// Tasks of which each precedes the next; the first and the last are the same. Empty: none.
  std::vector<std::uint32_t> circle() const;

 private:
  void forward();
  void backward();

  const Catalogue* catalogue_;
  std::vector<std::uint32_t> order_;
  std::vector<double> end_, latest_;
  std::vector<std::int64_t> cause_;  ///< -1: its own beginning
  std::vector<std::size_t> waiting_;
};

}  // namespace skein::auction
