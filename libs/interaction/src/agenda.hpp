// SPDX-License-Identifier: Apache-2.0
// Instants that are waited for.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "skein/foundation/time.hpp"

namespace skein::interaction {

/// A number of timers, each of which is set to one instant or to none. Cost of a change: O(log).
class Agenda {
 public:
  explicit Agenda(std::size_t timers) : set_(timers) {}

  void set(std::size_t timer, MissionTime at) {
    clear(timer);
    set_[timer] = at;
    due_.emplace(at, timer);
  }
  void clear(std::size_t timer) {
    if (set_[timer]) due_.erase({*set_[timer], timer});
    set_[timer].reset();
  }
  /// The first instant that one is set to.
  std::optional<MissionTime> next() const {
    return due_.empty() ? std::nullopt : std::optional(due_.begin()->first);
  }
  /// The timer that is set to this instant, the least of them; it is cleared.
  std::optional<std::size_t> take(MissionTime at) {
    if (due_.empty() || due_.begin()->first != at) return std::nullopt;
    const std::size_t timer = due_.begin()->second;
    clear(timer);
    return timer;
  }

 private:
  std::set<std::pair<MissionTime, std::size_t>> due_;
  std::vector<std::optional<MissionTime>> set_;  ///< by timer
};

}  // namespace skein::interaction
