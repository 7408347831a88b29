// SPDX-License-Identifier: Apache-2.0
// A directed channel of limited capacity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "channel_schedule.hpp"
#include "passing_samples.hpp"
#include "skein/blackboard/channel.hpp"
#include "waiting_values.hpp"

namespace skein::blackboard {

/// Decides what is written next on a channel. States, streams and relayed samples wait here;
/// heartbeats, events and parts, also of long states, wait in their sessions, so that they are up
/// to date when written.
class LimitedChannel {
 public:
  struct Turn {
    enum class Of : std::uint8_t { kHeartbeat, kEvents, kPart, kValue, kLongState };
    Of of = Of::kHeartbeat;
    wire::Slot slot = wire::Slot::kHeartbeat;  ///< of a value or a long state
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

  /// Queues a state or a stream.
  void put(wire::Sample value) { shed_ += values_.put(std::move(value)) ? 1 : 0; }
  void shed_one() { ++shed_; }
  /// A newer value goes another way.
  void drop(const wire::Sample& newer) { shed_ += values_.drop(newer) ? 1 : 0; }
  bool has_any() const { return !values_.empty() || !passing_.empty(); }
  /// Ends the scheduling. Returns the waiting states, to be written at once, so that the transport
  /// keeps them for late readers; waiting streams are dropped.
  std::vector<wire::Sample> let_go();
  /// States wait on; what is of the past by the time it is up again does not.
  void cut() {
    values_.take(wire::SlotClass::kStream);
    passing_.clear();
  }
  /// Queues an event, part or heartbeat that goes past a relay.
  void pass(wire::Sample sample) { passing_.put(std::move(sample)); }
  /// None that has expired.
  const wire::Sample* first_passing(MissionTime now) {
    passing_.drop_expired(now);
    return passing_.first();
  }
  wire::Sample take_passing() { return passing_.take(); }
  /// Number of values that were replaced by newer ones before they were written.
  std::uint64_t shed() const { return shed_; }

  /// Bytes of the first sample that waits in each session; 0: none waits.
  struct Waiting {
    std::size_t heartbeat = 0;
    std::size_t event = 0;  ///< the first one
    std::size_t part = 0;   ///< of a long event
    /// Of long states: part of one, in each slot that has any.
    std::vector<std::pair<wire::Slot, std::size_t>> long_states = {};
  };
  /// What is to be written now; nothing while a sample is under way or none waits.
  std::optional<Turn> next(const Waiting& first, Duration now);
  /// Notes that it is written now. Returns when its transmission ends.
  Duration write(const Turn& turn, Duration now) {
    return schedule_.write(turn.flow, turn.bytes, now);
  }
  /// Removes and returns the value whose turn it is.
  wire::Sample take(const Turn& turn);

 private:
  std::vector<wire::Slot> slots_;  ///< of the flows behind heartbeats and events
  ChannelSchedule schedule_;
  WaitingValues values_;
  PassingSamples passing_;
  bool turn_of_long_ = false;  ///< where a slot has long and short states
  std::uint64_t shed_ = 0;
};

}  // namespace skein::blackboard
