// SPDX-License-Identifier: Apache-2.0
// Mission time in a daemon: led by one, followed by the others through the clock slot.
#pragma once

#include <optional>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::node {

/// Follows the clock slot. Between samples, and if they stop coming, mission time goes on at the
/// last rate. It never goes back: a sample that was slow on its way is outweighed by a faster one,
/// and the estimate gives way slowly, so that clocks that drift stay together. A sample whose rate
/// is of no use (not within 0.001 and a million) is disregarded. Steady times are of this process
/// and never decrease. Source: spec 1.4.
class MissionClock {
 public:
  void update(const wire::Clock& sample, Duration steady);
  MissionTime now(Duration steady);
  /// The steady time at which mission time reaches `at`, to the microsecond; absent while time
  /// stands still.
  std::optional<Duration> steady_at(MissionTime at) const;
  wire::ClockPhase phase() const { return phase_; }
  double rate() const { return rate_; }

 private:
  double estimate(Duration steady) const;

  wire::ClockPhase phase_ = wire::ClockPhase::kHolding;
  double rate_ = 1;
  double offset_ = 0;   ///< [s] mission time minus rate × steady time
  double updated_ = 0;  ///< [s] steady
  MissionTime held_;    ///< while not running
  MissionTime last_;
};

/// Leads: holds at zero until told to run, then counts steady time × rate up to a limit.
class ClockLeader {
 public:
  explicit ClockLeader(double rate) : rate_(rate) {}

  void run(Duration steady);
  void finish(Duration steady);
  MissionTime now(Duration steady) const;
  std::optional<Duration> steady_at(MissionTime at) const;
  wire::ClockPhase phase() const { return phase_; }
  /// The clock slot's value at this instant.
  wire::Clock sample(Duration steady) const;

 private:
  double rate_;
  wire::ClockPhase phase_ = wire::ClockPhase::kHolding;
  Duration started_;
  MissionTime finished_;
};

}  // namespace skein::node
