// SPDX-License-Identifier: Apache-2.0
// Timers other than those of time conditions.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "skein/executive/task_state.hpp"
#include "skein/foundation/time.hpp"

namespace skein::executive {

/// Timers for the same instant expire in the order of their kinds, then of their ids.
struct Timer {
  enum class Kind : std::uint8_t { kUrgentWait, kTimeout, kBackgroundRetry, kSyncAgain };
  MissionTime at;
  Kind kind = Kind::kTimeout;
  TaskId id;  ///< of a background retry: the routine that is over
  auto operator<=>(const Timer&) const = default;
};

/// A task has one timer at most: another one, or drop(), voids it. Invariant: the first in the
/// queue is not void. Cost: O(log n) in the timers that were set and have not expired, void ones
/// included.
class Timers {
 public:
  void set(const Timer& timer);
  void drop(TaskId id);
  /// All timers of this kind expire at that instant instead.
  void put_off(Timer::Kind kind, MissionTime at);
  std::optional<MissionTime> next() const;
  /// The one that expires first. Precondition: next().
  Timer take();

 private:
  void trim();

  std::priority_queue<Timer, std::vector<Timer>, std::greater<>> queue_;
  std::unordered_map<TaskId, Timer> due_;
};

}  // namespace skein::executive
