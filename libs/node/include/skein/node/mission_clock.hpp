// SPDX-License-Identifier: Apache-2.0
// Mission time in a daemon: led by one, followed by the others through the clock slot.
#pragma once

#include <optional>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::node {

/// Follows the clock slot. Between samples mission time goes on at the last rate; if they stop
/// coming it stands still after a while, and goes on with the first that comes: a leader that died
/// and comes back is where the others are. It never goes back: a sample that was slow on its way is
/// outweighed by a faster one, and the estimate gives way slowly, so that clocks that drift stay
/// together. A sample whose rate is of no use (not within 0.001 and a million) is disregarded.
/// Steady times are of this process and never decrease. Source: spec 1.4.
class MissionClock {
 public:
  static constexpr Duration kSilence = Duration::milliseconds(500);  ///< steady: five periods

  /// `silence`: steady, after so much without a sample it stands still.
  explicit MissionClock(Duration silence = kSilence) : silence_(silence) {}

  void update(const wire::Clock& sample, Duration steady);
  MissionTime now(Duration steady);
  /// The steady time at which mission time reaches `at`, to the microsecond; absent while time
  /// stands still at the steady time `now`.
  std::optional<Duration> steady_at(MissionTime at, Duration now) const;
  wire::ClockPhase phase() const { return phase_; }
  double rate() const { return rate_; }

 private:
  double estimate(Duration steady) const;
  bool silent(Duration steady) const { return steady > heard_ + silence_; }

  Duration silence_;
  wire::ClockPhase phase_ = wire::ClockPhase::kHolding;
  double rate_ = 1;
  double offset_ = 0;   ///< [s] mission time minus rate × steady time
  double updated_ = 0;  ///< [s] steady
  MissionTime held_;    ///< while not running
  Duration heard_;      ///< steady; the last sample
  MissionTime last_;
};

/// Leads: holds until told to run, at zero or where a former life was, then counts steady time ×
/// rate up to a limit.
class ClockLeader {
 public:
  explicit ClockLeader(double rate) : rate_(rate) {}

  void run(Duration steady);
  /// It is `at` now, and runs or holds on. No earlier than any instant it gave.
  void set(MissionTime at, Duration steady);
  void finish(Duration steady);
  MissionTime now(Duration steady) const;
  std::optional<Duration> steady_at(MissionTime at) const;
  wire::ClockPhase phase() const { return phase_; }
  /// The clock slot's value at this instant.
  wire::Clock sample(Duration steady) const;

 private:
  double rate_;
  wire::ClockPhase phase_ = wire::ClockPhase::kHolding;
  Duration started_;  ///< when `from_` was, while running
  MissionTime from_;
  MissionTime finished_;
};

}  // namespace skein::node
