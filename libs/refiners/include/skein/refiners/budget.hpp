// SPDX-License-Identifier: Apache-2.0
// Bounds on the search of a refiner.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

namespace skein::refiners {

/// Two bounds: a number of steps, which keeps results reproducible on any machine, and the host's
/// clock, which is polled and takes precedence. A search that the clock ends returns the best
/// result so far and sets Effort::cut_short. A value type.
struct Budget {
  /// Returns true once the time is up. Empty: no time limit. Called from the thread of the service,
  /// every few thousand elementary operations (some 50 µs).
  std::function<bool()> time_is_up;
  /// Limit of elementary steps; each service documents its unit (expansions, moves tried, …).
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();

  bool expired() const { return time_is_up && time_is_up(); }
};

/// Counts steps against a budget; polls its clock only every `stride` steps, since polling costs
/// more than a step.
/// Thread rule: one thread.
class Countdown {
 public:
  explicit Countdown(const Budget& budget, std::uint32_t stride = 1024)
      : budget_(budget), stride_(stride) {}
  /// Counts one step; false once either bound is reached, and from then on.
  bool step() {
    if (over_) return false;
    ++steps_;
    over_ = steps_ > budget_.steps || (steps_ % stride_ == 0 && out_of_time());
    return !over_;
  }
  std::uint64_t steps() const { return steps_; }
  bool over() const { return over_; }
  /// True if the clock ended the search, so that the result may differ between runs.
  bool cut_short() const { return cut_short_; }

 private:
  bool out_of_time() { return cut_short_ = budget_.expired(); }

  const Budget& budget_;
  std::uint32_t stride_;
  std::uint64_t steps_ = 0;
  bool over_ = false, cut_short_ = false;
};

}  // namespace skein::refiners
