// SPDX-License-Identifier: Apache-2.0
// How long a joint task that loads waits for its partners.
#pragma once

#include <optional>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/mission/elementary_plan.hpp"

namespace skein::decision_node {

/// Attempts at the same joint task on this UAV.
struct EarlierAttempts {
  bool has_run = false;                      ///< and failed
  std::optional<MissionTime> waits_since{};  ///< one that never ran has just failed: since then
};

/// Until it is to start at the latest; where that is not said, some time after it could have: its
/// plan is made anew while it waits, and could begin it anew each time. Where it has run and
/// failed, it is due: whom it failed for comes back soon, or is done without. An attempt after one
/// that has just failed has what is left of the time of both, and a minute at least. A value.
class LoadingTime {
 public:
  static constexpr double kForever = 1e8;  ///< no latest start [s]
  static constexpr Duration kTryFor = Duration::milliseconds(600'000);
  static constexpr Duration kTryAgainFor = Duration::milliseconds(60'000);

  void follows(const EarlierAttempts& before) { before_ = before; }
  /// It may start in these intervals, by the plan that was made now.
  void plan(const std::vector<mission::Interval>& starts, MissionTime now);
  /// From when it, or one before, could begin.
  MissionTime since() const { return since_; }
  MissionTime until() const { return until_; }

 private:
  EarlierAttempts before_;
  std::optional<MissionTime> due_since_;  ///< it could begin at once, and has waited for others
  MissionTime since_, until_;
};

}  // namespace skein::decision_node
