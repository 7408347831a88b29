// SPDX-License-Identifier: Apache-2.0
// Mission time in a daemon: one daemon leads the clock, the others follow through the clock slot.
#pragma once

#include <optional>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::node {

/// A follower of the clock slot. Between samples mission time advances at the last rate. After
/// `silence` without samples it stands still until the next one, so that a leader that restarts
/// resumes where its followers are. It never decreases. The estimate follows the least delayed
/// samples and forgets slowly, so that delays have little effect and drifting clocks stay together.
/// Samples with a rate outside [0.001, 1e6] are ignored. Steady times are of this process and must
/// not decrease. Source: spec 1.4.
class MissionClock {
 public:
  static constexpr Duration kSilence = Duration::milliseconds(500);  ///< steady: five periods

  /// `silence`: steady time without a sample after which mission time stands still.
  explicit MissionClock(Duration silence = kSilence) : silence_(silence) {}

  void update(const wire::Clock& sample, Duration steady);
  MissionTime now(Duration steady);
  /// The steady time at which mission time reaches `at`, to the microsecond; absent while mission
  /// time stands still. `now`: steady.
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

/// The leader's clock: holds (at zero, or at the mission time of a former life) until run(), then
/// advances by steady time × rate until finish().
class ClockLeader {
 public:
  explicit ClockLeader(double rate) : rate_(rate) {}

  void run(Duration steady);
  /// Sets mission time to `at`; the phase stays. Precondition: `at` is not before any instant that
  /// now() has returned.
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

/// How long a leader that comes back listens before it leads: its followers may have gone on a
/// little and know best what time it is. At least `least`, so that of several the latest is heard;
/// and on a busy machine, where it takes the middleware longer until any of them is heard, up to
/// kAtMost. All times are steady.
class LeaderListening {
 public:
  static constexpr Duration kAtMost = Duration::milliseconds(5'000);

  LeaderListening(Duration since, Duration least);

  bool is_over(Duration steady, bool heard) const;
  /// When to ask again, if nobody is heard before.
  Duration next(Duration steady) const { return steady < least_ ? least_ : most_; }

 private:
  Duration least_;
  Duration most_;
};

}  // namespace skein::node
