// SPDX-License-Identifier: Apache-2.0
// What has passed between this node and one peer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sessions/lives.hpp"
#include "sessions/long_states.hpp"
#include "sessions/outgoing_events.hpp"
#include "sessions/outgoing_parts.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Both halves of the event session with a peer. Long events are numbered apart, from
/// kFirstLongEvent, and go in parts: by its number an event is in the one half or the other.
struct Session {
  /// The configuration outlives it.
  explicit Session(const Config& config);

  /// Whether there is no room to hold another one until it is acknowledged.
  bool full(bool long_event) const;
  /// The sequence number that the header of the next one must carry for hold().
  std::uint64_t next_number(bool long_event) const;
  void hold(wire::Sample event, std::uint64_t receipt);
  /// The number of those held.
  std::size_t unacknowledged() const { return outgoing.size() + parts_out.size(); }
  /// Everything is to be said again.
  void resend();
  void set_contact(bool contact);
  /// Towards the peer this node, `self`, has that incarnation from now on.
  void become(NodeNumber self, std::uint64_t incarnation);
  std::vector<EventExpired> expire(MissionTime now);
  std::optional<MissionTime> first_expiry() const;

  // Restoration from former lives; see Blackboard.
  void recall_sent(wire::Sample event, std::uint64_t receipt);
  void recall_acknowledged(std::uint64_t number);
  void recall_given_up(std::uint64_t number);
  void recall_received(const wire::SampleHeader& header);

  OutgoingEvents outgoing;
  OutgoingParts parts_out;  ///< of long events
  LongStates long_states;
  Lives lives;
};

}  // namespace skein::blackboard
