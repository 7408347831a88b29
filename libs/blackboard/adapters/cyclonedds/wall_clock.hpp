// SPDX-License-Identifier: Apache-2.0
// A wall clock that somebody may set, beside one that nobody can.
#pragma once

#include <chrono>
#include <optional>

namespace skein::blackboard::cyclonedds {

/// Cyclone DDS 0.10 waits for a duration until an instant of the wall clock: when that is set back
/// by a day, its threads (timed events, garbage, leases) wait a day more unless something wakes
/// them. Source: ddsrt_cond_waitfor of its src/ddsrt/src/sync/posix/sync.c.
class WallClock {
 public:
  using Wall = std::chrono::system_clock::time_point;
  using Steady = std::chrono::steady_clock::time_point;
  /// Slow corrections of the clock stay below it: 500 ppm of one minute between two calls.
  static constexpr std::chrono::milliseconds kSet{30};

  /// True if it was set back, by more than kSet, since it was last looked at.
  bool set_back() { return set_back(Wall::clock::now(), Steady::clock::now()); }
  bool set_back(Wall wall, Steady steady) {
    const auto ahead = wall.time_since_epoch() - steady.time_since_epoch();
    const bool back = ahead_ && ahead < *ahead_ - kSet;
    ahead_ = ahead;
    return back;
  }

 private:
  std::optional<std::chrono::nanoseconds> ahead_;  ///< of the steady one
};

}  // namespace skein::blackboard::cyclonedds
