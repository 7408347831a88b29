// SPDX-License-Identifier: Apache-2.0
// Timers other than those of time conditions.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "skein/executive/task_state.hpp"
#include "skein/foundation/time.hpp"

namespace skein::executive {

/// Timers for the same instant expire in the order of their kinds, then of their ids.
struct Timer {
  enum class Kind : std::uint8_t { kUrgentWait, kTimeout, kBackgroundRetry, kSyncAgain };
  MissionTime at;
  Kind kind = Kind::kTimeout;
  TaskId id;
  auto operator<=>(const Timer&) const = default;
};

/// A queue of timers. Timers are never cancelled: their owner knows whether one is still valid.
class Timers {
 public:
  void set(Timer timer) { queue_.push(timer); }
  std::optional<MissionTime> next() const {
    if (queue_.empty()) return std::nullopt;
    return queue_.top().at;
  }
  const Timer& first() const { return queue_.top(); }
  Timer take() {
    const Timer timer = queue_.top();
    queue_.pop();
    return timer;
  }
  bool empty() const { return queue_.empty(); }

 private:
  std::priority_queue<Timer, std::vector<Timer>, std::greater<>> queue_;
};

}  // namespace skein::executive
