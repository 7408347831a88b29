// SPDX-License-Identifier: Apache-2.0
// The clock of a budget, for work that its steps do not count.
#pragma once

#include <cstdint>
#include <functional>

#include "skein/refiners/budget.hpp"

namespace skein::refiners {

/// Asked often and cheaply: work is told by about how long it takes, and the clock is asked once
/// enough has come together. Once the time is up it stays so: what is begun then is not wanted any
/// more, and ends as soon as it can. Thread rule: one thread.
class Deadline {
 public:
  explicit Deadline(const Budget& budget) : time_is_up_(budget.time_is_up) {}

  /// False: there is no clock, the time is never up.
  bool is_set() const { return static_cast<bool>(time_is_up_); }
  /// After that much more work [ns]; true once the time is up.
  bool passed_after(std::uint32_t work) {
    constexpr std::uint32_t kEnough = 100'000;
    if (passed_ || !time_is_up_) return passed_;
    work_ += work;
    return work_ >= kEnough ? passed() : false;
  }
  /// As far as is known: the clock is not asked.
  bool is_over() const { return passed_; }
  /// By the clock, now.
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
