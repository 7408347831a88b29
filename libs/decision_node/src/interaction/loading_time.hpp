// SPDX-License-Identifier: Apache-2.0
// How long a joint task that loads waits for its partners.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/mission/elementary_plan.hpp"

namespace skein::decision_node {

/// Attempts at the same joint task on this UAV.
struct EarlierAttempts {
  bool has_run = false;                          ///< and failed
  std::optional<MissionTime> waits_since{};      ///< one that never ran has just failed: since then
  std::map<std::string, MissionTime> engaged{};  ///< partners, and until when, as they said last
  std::optional<MissionTime> asked_at{};  ///< one that never ran has just failed: its loading
};

/// Until it is to start at the latest; where that is not said, some time after it could have: its
/// plan is made anew while it waits, and could begin it anew each time. Where it has run and
/// failed, it is due: whom it failed for comes back soon, or is done without. An attempt after one
/// that has just failed has what is left of the time of both, and a minute at least.
///
/// This UAV and its partners may be engaged: they wait for joint tasks that come before this one in
/// their plans, until some time at most. Then it is tried until a minute later, unless it is to
/// start before. A value.
class LoadingTime {
 public:
  static constexpr double kForever = 1e8;  ///< no latest start [s]
  static constexpr Duration kTryFor = Duration::milliseconds(600'000);
  static constexpr Duration kTryAgainFor = Duration::milliseconds(60'000);

  void follows(const EarlierAttempts& before);
  /// It may start in these intervals, by the plan that was made now.
  void plan(const std::vector<mission::Interval>& starts, MissionTime now);
  /// The same, of one that waited for something else than partners until now.
  void put_off(const std::vector<mission::Interval>& starts, MissionTime now);
  /// This UAV is engaged until then at most; absent: it is not.
  void engage(std::optional<MissionTime> until) { engaged_ = until; }
  /// A partner says so of itself. One that is not engaged any more was until now.
  void engage(const std::string& partner, std::optional<MissionTime> until, MissionTime now);
  /// All were to begin then; absent: that is not agreed on.
  void agree(std::optional<MissionTime> start) { agreed_ = start; }

  std::optional<MissionTime> engaged() const { return engaged_; }
  const std::map<std::string, MissionTime>& engaged_partners() const { return partners_; }
  /// From when it, or one before, could begin; while this UAV is engaged, not before now.
  MissionTime since(MissionTime now) const { return engaged_ ? now : since_; }
  MissionTime until() const { return tried_until(kTryAgainFor); }
  /// Until when this UAV itself waits: those who wait for it add their minute.
  MissionTime waits_until() const { return tried_until({}); }

 private:
  MissionTime tried_until(Duration after_engagements) const;

  EarlierAttempts before_;
  std::optional<MissionTime> due_since_;  ///< it could begin at once, and has waited for others
  MissionTime since_, until_;
  std::optional<MissionTime> engaged_, agreed_;
  std::map<std::string, MissionTime> partners_;  ///< engaged until then
  bool bounded_ = false;                         ///< the latest start is said
};

}  // namespace skein::decision_node
