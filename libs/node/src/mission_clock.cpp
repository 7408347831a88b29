// SPDX-License-Identifier: Apache-2.0
#include "skein/node/mission_clock.hpp"

#include <algorithm>

namespace skein::node {

namespace {

/// How fast an estimate made early gives way, as a share of the rate: faster than crystals drift,
/// slower than anything notices.
constexpr double kGivingWay = 1e-3;

/// Rates of any use; a sample outside of them is not from one of us.
constexpr double kLeastRate = 1e-3;
constexpr double kGreatestRate = 1e6;

}  // namespace

double MissionClock::estimate(Duration steady) const {
  const double s = steady.to_seconds();
  return rate_ * (s - kGivingWay * (s - updated_)) + offset_;
}

void MissionClock::update(const wire::Clock& sample, Duration steady) {
  if (!(sample.rate >= kLeastRate && sample.rate <= kGreatestRate)) return;
  const MissionTime time = MissionTime::nanoseconds(sample.time);
  const double implied = time.to_seconds() - sample.rate * steady.to_seconds();
  const bool first = phase_ != wire::ClockPhase::kRunning || sample.rate != rate_ || silent(steady);
  if (first || rate_ * steady.to_seconds() + implied >= estimate(steady)) {
    offset_ = implied;
    updated_ = steady.to_seconds();
  }
  phase_ = sample.phase;
  rate_ = sample.rate;
  held_ = time;
  heard_ = steady;
}

MissionTime MissionClock::now(Duration steady) {
  const MissionTime at = phase_ == wire::ClockPhase::kRunning
                             ? MissionTime::seconds(estimate(std::min(steady, heard_ + silence_)))
                             : held_;
  last_ = std::max(last_, at);
  return last_;
}

std::optional<Duration> MissionClock::steady_at(MissionTime at, Duration now) const {
  if (phase_ != wire::ClockPhase::kRunning || silent(now)) return std::nullopt;
  const double s = (at.to_seconds() - offset_) / rate_;
  return Duration::seconds((s - kGivingWay * updated_) / (1 - kGivingWay));
}

void ClockLeader::run(Duration steady) {
  if (phase_ != wire::ClockPhase::kHolding) return;
  phase_ = wire::ClockPhase::kRunning;
  started_ = steady;
}

void ClockLeader::set(MissionTime at, Duration steady) {
  from_ = at;
  started_ = steady;
}

void ClockLeader::finish(Duration steady) {
  finished_ = now(steady);
  phase_ = wire::ClockPhase::kFinished;
}

MissionTime ClockLeader::now(Duration steady) const {
  if (phase_ == wire::ClockPhase::kHolding) return from_;
  if (phase_ == wire::ClockPhase::kFinished) return finished_;
  return from_ + Duration::seconds((steady - started_).to_seconds() * rate_);
}

std::optional<Duration> ClockLeader::steady_at(MissionTime at) const {
  if (phase_ != wire::ClockPhase::kRunning) return std::nullopt;
  return started_ + Duration::seconds((at - from_).to_seconds() / rate_);
}

wire::Clock ClockLeader::sample(Duration steady) const {
  wire::Clock clock;
  clock.time = now(steady).count();
  clock.rate = rate_;
  clock.phase = phase_;
  return clock;
}

LeaderListening::LeaderListening(Duration since, Duration least)
    : least_(since + least), most_(since + std::max(least, kAtMost)) {}

bool LeaderListening::is_over(Duration steady, bool heard) const {
  return steady >= (heard ? least_ : most_);
}

}  // namespace skein::node
