// SPDX-License-Identifier: Apache-2.0
// The heartbeats of this node on the world channel.
#pragma once

#include <cstdint>
#include <optional>

#include "publishers.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// When the next heartbeat is due, by the steady clock, and its number. None is, until it begins.
class Pulse {
 public:
  /// `before`: the number of the last one of earlier lives, or less than the first.
  explicit Pulse(std::uint64_t before) : number_(before) {}

  void begin() { next_ = Duration{}; }
  std::optional<Duration> next() const { return next_; }
  /// The number of the heartbeat to be published now; absent: none is due.
  std::optional<std::uint64_t> beat(Duration steady) {
    if (!next_ || steady < *next_) return std::nullopt;
    next_ = steady + kPublishedHeartbeat;
    return ++number_;
  }

 private:
  std::optional<Duration> next_;
  std::uint64_t number_;
};

}  // namespace skein::blackboard
