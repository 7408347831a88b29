// SPDX-License-Identifier: Apache-2.0
// Time limit of long work: decides when its clock is asked.
#pragma once

#include <cstddef>
#include <functional>

namespace skein::world {

/// Sums up estimates of the work done, and asks the clock once per some milliseconds of work, so
/// that shorter work is always completed. Once the time is up it stays so. The clock must outlive
/// this object; an empty clock is never up. Thread rule: one thread.
class WorkClock {
 public:
  explicit WorkClock(const std::function<bool()>& time_is_up) : time_is_up_(time_is_up) {}

  /// Whether the time is up after this much more work [ns].
  bool is_up_after(std::size_t work) {
    constexpr std::size_t kEnough = 4'000'000;
    if (is_up_ || !time_is_up_) return is_up_;
    work_ += work;
    if (work_ < kEnough) return false;
    work_ = 0;
    return is_up_ = time_is_up_();
  }

 private:
  const std::function<bool()>& time_is_up_;
  std::size_t work_ = 0;
  bool is_up_ = false;
};

}  // namespace skein::world
