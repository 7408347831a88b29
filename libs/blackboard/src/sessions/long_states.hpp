// SPDX-License-Identifier: Apache-2.0
// States that a channel of limited capacity carries in parts.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "sessions/outgoing_parts.hpp"
#include "waiting_values.hpp"

namespace skein::blackboard {

/// The states that are too long to be said at once over a channel of limited capacity: whoever else
/// has something to say would wait for the end. They go to one peer in parts, one state after the
/// other; of each only the newest value waits. What is under way goes on to its end: a newer value
/// takes its place only if no more than the first part was written, and not twice in a row, or if
/// all of it was, whatever the peer has said of that. What
/// was said is kept for the peer's next life, as the transport keeps shorter ones. Memory: one
/// value for each (slot, instance) that was long.
class LongStates {
 public:
  /// True if `state` replaced an older value that waited.
  bool put(wire::Sample state);
  /// A newer value goes another way: older ones need not be said any more. True if one waited.
  bool drop(const wire::Sample& newer);
  /// Those with this origin are said anew by other means.
  void drop_from(std::uint32_t origin);
  /// All of them, older values first, to be written at once; none is left.
  std::vector<wire::Sample> let_go();
  /// The peer has restarted: it has nothing of what it was told.
  void begin_again();
  /// The peer is reachable again.
  void resend() { parts_.resend(); }
  /// The peer has all states before `number`, and this many bytes of that one; `lacks`: later ones
  /// have come.
  void heard(std::uint64_t number, std::uint32_t bytes, bool lacks);

  /// What may go now, in each slot: bytes that the next part takes on a channel; one of the state
  /// under way, or, if there is none, the first of any that waits.
  std::vector<std::pair<wire::Slot, std::size_t>> due(Duration now, std::uint32_t most_bytes,
                                                      Duration time_out) const;
  /// The next part of the slot whose turn it is, without header; its transmission ends at `until`
  /// (steady). Precondition: it is among those due.
  wire::Part take(wire::Slot slot, std::uint32_t most_bytes, Duration now, Duration time_out,
                  Duration until);
  /// Steady, when due() has something.
  std::optional<Duration> next_due(std::uint32_t most_bytes, Duration time_out) const;

 private:
  bool is_under_way(const wire::Sample& like) const;
  void end_current();

  WaitingValues waiting_;
  std::optional<wire::Sample> under_way_;
  int written_ = 0;            ///< parts of it
  bool was_replaced_ = false;  ///< the one before it, by a newer value
  WaitingValues told_;
  OutgoingParts parts_{1};
};

}  // namespace skein::blackboard
