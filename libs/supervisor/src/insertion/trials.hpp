// SPDX-License-Identifier: Apache-2.0
// Orders tried one after another, of which the best is kept.
#pragma once

#include <optional>
#include <vector>

#include "insertion/blocks.hpp"
#include "insertion/sketch.hpp"

namespace skein::supervisor {

class Trials {
 public:
  explicit Trials(Judge& judge) : judge_(judge) {}

  /// Plans that order, unless it is known from before, and keeps it if it serves and
  /// shortens less than the best so far, or as little and costs less.
  const Verdict& run(mission::Placement placement, const Goals& order);

  struct Best {
    mission::Placement placement = mission::Placement::kLast;
    Goals order;
    const Verdict* verdict = nullptr;  ///< lives as long as the judge
  };
  const std::optional<Best>& best() const { return best_; }
  const std::vector<Trial>& all() const { return trials_; }
  std::vector<Trial> take() { return std::move(trials_); }
  /// Why none serves: of every trial, each once.
  std::vector<std::string> reasons() const;

 private:
  static bool is_better(const Verdict& a, const Verdict& b);

  Judge& judge_;
  std::vector<Trial> trials_;
  std::optional<Best> best_;
};

/// What each task takes, from a plan of all of them in that order without their constraints; when
/// there is none, from plans of each alone.
Sketch sketch_of(const Judge& judge, const Goals& order);

}  // namespace skein::supervisor
