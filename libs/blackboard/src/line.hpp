// SPDX-License-Identifier: Apache-2.0
// The channels to and from one peer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "limited_channel.hpp"
#include "round_trip.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// The channels to and from a peer, as indices into Config::channels.
struct PeerChannels {
  NodeNumber number;
  ChannelKind kind = ChannelKind::kRadio;
  std::size_t outgoing = 0;
  std::size_t incoming = 0;
};

/// In what condition the channels to and from a peer are, or past how many relays the way goes; and
/// what follows from that: how long an answer may take, what is too long to be said at once, and,
/// on a channel of limited capacity, a scheduler. Durations are steady.
class Line {
 public:
  /// The configuration outlives it.
  Line(PeerChannels channels, const Config& config);

  const PeerChannels& channels() const { return channels_; }
  const ChannelCondition& outgoing() const { return outgoing_; }
  const ChannelCondition& incoming() const { return incoming_; }
  void set_outgoing(const ChannelCondition& condition, Duration now);
  void set_incoming(const ChannelCondition& condition) { incoming_ = condition; }
  /// The route has this many relays (0: direct). `heard_of`: relays connect the peer to this node.
  void set_way(std::size_t relays, bool heard_of);

  bool is_relayed() const { return relays_ > 0; }
  /// Whether samples can reach the peer, as far as is known here.
  bool can_send() const { return is_relayed() || outgoing_.up; }
  /// Of a peer in contact, until it counts as lost.
  Duration silence_limit() const;
  /// Delay of channels and acknowledgements, to be added to time-outs.
  RoundTrip round_trip() const;

  /// The scheduler of the channel to the peer; null if its capacity is unlimited.
  LimitedChannel* limited() { return limited_.get(); }
  const LimitedChannel* limited() const { return limited_.get(); }
  /// Whether the event is sent in parts; the same in every life.
  bool is_long_event(const wire::Sample& event) const;
  /// Whether the state is sent in parts. Precondition: limited().
  bool is_long_state(const wire::Sample& state) const;
  std::uint32_t bytes_of_a_part() const;

 private:
  void limit(double capacity, Duration now);

  PeerChannels channels_;
  const Config* config_;
  ChannelCondition outgoing_;
  ChannelCondition incoming_;
  std::unique_ptr<LimitedChannel> limited_;
  std::size_t relays_ = 0;
  bool heard_of_ = false;
};

}  // namespace skein::blackboard
