// SPDX-License-Identifier: Apache-2.0
// Polls the clock of a budget during work that is not counted in steps.
#pragma once

#include <cstdint>
#include <functional>

#include "skein/refiners/budget.hpp"

namespace skein::refiners {

/// Cheap to call often: callers report the estimated duration of their work, and the clock is
/// polled once enough work has been reported. Once the time is up it stays so; running work should
/// then end as soon as possible, since its result is discarded. Thread rule: one thread.
class Deadline {
 public:
  explicit Deadline(const Budget& budget) : time_is_up_(budget.time_is_up) {}

  /// False: there is no clock, so the time is never up.
  bool is_set() const { return static_cast<bool>(time_is_up_); }
  /// Reports the estimated duration [ns] of further work; true once the time is up.
  bool passed_after(std::uint32_t work) {
    constexpr std::uint32_t kEnough = 100'000;
    if (passed_ || !time_is_up_) return passed_;
    work_ += work;
    return work_ >= kEnough ? passed() : false;
  }
  /// Whether the time was up at the last poll.
  bool is_over() const { return passed_; }
  /// Polls the clock; true once the time is up.
  bool passed() {
    work_ = 0;
    return passed_ = passed_ || (time_is_up_ && time_is_up_());
  }

 private:
  std::function<bool()> time_is_up_;
  std::uint32_t work_ = 0;
  bool passed_ = false;
};

}  // namespace skein::refiners
