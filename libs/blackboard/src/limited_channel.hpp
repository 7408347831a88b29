// SPDX-License-Identifier: Apache-2.0
// A directed channel that cannot carry everything at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "channel_schedule.hpp"
#include "skein/blackboard/channel.hpp"
#include "waiting_values.hpp"

namespace skein::blackboard {

/// Whose turn it is on a channel, and what waits for it. Heartbeats and events wait where they are
/// made, so that what goes out is what holds then; states and streams wait here.
class LimitedChannel {
 public:
  struct Turn {
    enum class Of : std::uint8_t { kHeartbeat, kEvents, kPart, kValue };
    Of of = Of::kHeartbeat;
    wire::Slot slot = wire::Slot::kHeartbeat;  ///< of a value
    std::size_t flow = 0;
    std::size_t bytes = 0;
  };

  /// Parts of long events are a flow of their own. Events of all slots are in one order and share
  /// one flow: its fraction is the sum of theirs, its priority the greatest of them. Heartbeats get
  /// at least what one every `heartbeat_period` takes: without them there is no contact.
  LimitedChannel(const std::vector<wire::Slot>& slots, const SlotShares& shares,
                 Duration heartbeat_period);

  /// Steady, > 0.
  void set_capacity(double bits_per_second, Duration now) {
    schedule_.set_capacity(bits_per_second, now);
  }
  double capacity() const { return schedule_.capacity(); }
  Duration airtime(std::size_t bytes) const { return schedule_.airtime(bytes); }
  Duration free_at() const { return schedule_.free_at(); }

  /// A state or a stream.
  void put(wire::Sample value) { shed_ += values_.put(std::move(value)) ? 1 : 0; }
  bool has_any() const { return !values_.empty() || !passing_.empty(); }
  /// It takes no turns any more. Gives the last states, which are written at once: there late
  /// comers find them; streams are of the past.
  std::vector<wire::Sample> let_go();
  /// An event, or a heartbeat of another one, on its way to somebody else. Of too many the oldest
  /// goes: who made it sends it again.
  void pass(wire::Sample sample);
  const wire::Sample* first_passing() const {
    return passing_.empty() ? nullptr : &passing_.front();
  }
  wire::Sample take_passing();
  /// Values that a newer one took the place of before their turn came.
  std::uint64_t shed() const { return shed_; }

  /// Bytes of what waits where it is made; 0: none waits.
  struct Waiting {
    std::size_t heartbeat = 0;
    std::size_t event = 0;  ///< the first one
    std::size_t part = 0;   ///< of a long event
  };
  /// Whose turn it is now. None while something is under way or nothing waits.
  std::optional<Turn> next(const Waiting& first, Duration now);
  /// It is being written; gives when that ends.
  Duration write(const Turn& turn, Duration now) {
    return schedule_.write(turn.flow, turn.bytes, now);
  }
  /// The value whose turn it is; it waits no more.
  wire::Sample take(const Turn& turn);

 private:
  std::vector<wire::Slot> slots_;  ///< of the flows behind heartbeats and events
  ChannelSchedule schedule_;
  WaitingValues values_;
  std::deque<wire::Sample> passing_;
  std::uint64_t shed_ = 0;
};

}  // namespace skein::blackboard
