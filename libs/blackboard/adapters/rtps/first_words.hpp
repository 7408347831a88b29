// SPDX-License-Identifier: Apache-2.0
// The samples of new stream writers, repeated for readers that are discovered later.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <tuple>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::rtps {

/// Of the streams whose writers are new, the last value of each instance: the first one may be all
/// that there is (the one look that a task takes), and readers come only when there is a writer. It
/// is said again whenever a reader is found; who has it already takes it for old. Kept until the
/// first reader is there and the writer is no longer new: others, as a spy, may be found first.
/// Thread rule: one thread. Cost: a copy of each sample, as long as it lasts.
class FirstWords {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kNew{10};

  /// A writer of the slot was made.
  void begin(wire::Slot slot, Clock::time_point now);
  /// The writer has written this sample.
  void keep(const wire::Sample& sample, Clock::time_point now);
  /// The writer has matched a reader: calls `use` with the samples to be repeated.
  void found(wire::Slot slot, Clock::time_point now,
             const std::function<void(const wire::Sample&)>& use);
  /// All writers were deleted: forgets their samples.
  void clear() { streams_.clear(); }

 private:
  /// Origin, destination, instance.
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
  struct Stream {
    Clock::time_point made;
    bool found = false;
    std::map<Key, wire::Sample> last;
  };
  static bool is_new(const Stream& stream, Clock::time_point now);

  std::map<wire::Slot, Stream> streams_;
};

}  // namespace skein::blackboard::rtps
