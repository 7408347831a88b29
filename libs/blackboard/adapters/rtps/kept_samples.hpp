// SPDX-License-Identifier: Apache-2.0
// What the writers of a channel must say again when they are made anew.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <tuple>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::rtps {

/// How long an event stays in the history of a writer, but for the world's. Sessions make good what
/// is older.
inline constexpr std::chrono::seconds kEventLifespan{10};

/// The history of the writers of one channel that may be cut, beside that of DDS: a cut deletes
/// the writers, and their history with them. Keeps the last value of each (slot, origin,
/// destination, instance) of the states, the last kEventDepth events of each slot, and no stream.
/// Thread rule: one thread. Cost: a copy of each sample.
class KeptSamples {
 public:
  using Clock = std::chrono::steady_clock;

  void keep(const wire::Sample& sample, Clock::time_point now);
  /// States first, then the events that are younger than kEventLifespan, slot by slot in the order
  /// in which they were kept.
  void for_each(Clock::time_point now, const std::function<void(const wire::Sample&)>& use) const;

 private:
  struct Event {
    Clock::time_point at;
    wire::Sample sample;
  };
  /// Slot, origin, destination, instance.
  using StateKey = std::tuple<wire::Slot, std::uint32_t, std::uint32_t, std::uint32_t>;
  std::map<StateKey, wire::Sample> states_;
  std::map<wire::Slot, std::deque<Event>> events_;
};

}  // namespace skein::blackboard::rtps
