// SPDX-License-Identifier: Apache-2.0
// Queue of relayed samples for a channel of limited capacity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// Events, parts and heartbeats that go past a relay: those of each author to each receiver in
/// their order, and the pairs of author and receiver in turn, so that what one has saved up for
/// another during a cut keeps nobody else waiting. Of a pair's heartbeats only the last waits: it
/// says all that those before it said. Heartbeats and events take turns, so that on a channel that
/// carries no more than the heartbeats of all pairs events come through too. Memory: kEventDepth
/// events in all.
class PassingSamples {
 public:
  /// An event that waits already, which its author repeats, takes its own place: it may be empty
  /// since it has expired. If there are too many, the oldest of the pair with the most is dropped;
  /// its author sends it again.
  void put(wire::Sample sample);
  /// Drops what would come too late: its author says so, or sends it again empty.
  void drop_expired(MissionTime now);
  bool empty() const { return pairs_.empty(); }
  /// The next one; null if none waits. Valid until the next call of another function.
  const wire::Sample* first() const;
  /// Removes and returns it; there must be one.
  wire::Sample take();
  void clear();

 private:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;  ///< origin, destination
  struct Pair {
    std::optional<wire::Sample> heartbeat;
    std::deque<wire::Sample> events;
  };
  bool has_heartbeat_next() const { return !beats_.empty() && (turns_.empty() || !beat_was_last_); }
  void drop_one();
  /// The pairs for which nothing waits any more.
  void forget_empty();

  std::map<Ends, Pair> pairs_;  ///< those for which anything waits
  std::deque<Ends> beats_;      ///< pairs whose heartbeat waits, the next one first
  std::deque<Ends> turns_;      ///< pairs whose events wait
  bool beat_was_last_ = false;
  std::size_t events_ = 0;
};

}  // namespace skein::blackboard
