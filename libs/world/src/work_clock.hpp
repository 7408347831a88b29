// SPDX-License-Identifier: Apache-2.0
// When a clock is asked between pieces of long work.
#pragma once

#include <cstddef>
#include <functional>

namespace skein::world {

/// Work is told by about how long it takes, and the clock is asked once some milliseconds of it
/// have come together: what takes less is done whatever the clock says. Once the time is up it
/// stays so. The clock must outlive it; an empty one is never up. Thread rule: one thread.
class WorkClock {
 public:
  explicit WorkClock(const std::function<bool()>& time_is_up) : time_is_up_(time_is_up) {}

  /// After that much more work [ns].
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
