// SPDX-License-Identifier: Apache-2.0
// Tries orders one after another and keeps the best.
#pragma once

#include <optional>
#include <vector>

#include "insertion/blocks.hpp"
#include "insertion/sketch.hpp"

namespace skein::supervisor {

class Trials {
 public:
  explicit Trials(Judge& judge) : judge_(judge) {}

  /// Judges the order, and keeps it as the best if it is feasible and shortens durations by less
  /// than the best so far, or by as much at less cost.
  const Verdict& run(mission::Placement placement, const Goals& order);

  struct Best {
    mission::Placement placement = mission::Placement::kLast;
    Goals order;
    const Verdict* verdict = nullptr;  ///< lives as long as the judge
  };
  const std::optional<Best>& best() const { return best_; }
  const std::vector<Trial>& all() const { return trials_; }
  std::vector<Trial> take() { return std::move(trials_); }
  /// Why no order is feasible: the reasons of all trials, each once.
  std::vector<std::string> reasons() const;

 private:
  static bool is_better(const Verdict& a, const Verdict& b);

  Judge& judge_;
  std::vector<Trial> trials_;
  std::optional<Best> best_;
};

/// The sketch from a plan of `order` without time constraints; if there is no such plan, from plans
/// of each task alone.
Sketch sketch_of(const Judge& judge, const Goals& order);

}  // namespace skein::supervisor
