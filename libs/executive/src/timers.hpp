// SPDX-License-Identifier: Apache-2.0
// Instants at which something other than a condition is due.
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

/// At one instant they go off in the order of their kinds, then of their ids.
struct Timer {
  enum class Kind : std::uint8_t { kUrgentWait, kTimeout, kBackgroundRetry, kSyncAgain };
  MissionTime at;
  Kind kind = Kind::kTimeout;
  TaskId id;
  auto operator<=>(const Timer&) const = default;
};

/// A timer is never taken out early: whoever set it knows whether it still counts.
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
