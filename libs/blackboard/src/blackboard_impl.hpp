// SPDX-License-Identifier: Apache-2.0
// Implementation of Blackboard.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "connections.hpp"
#include "delays.hpp"
#include "directory.hpp"
#include "drops.hpp"
#include "freshness.hpp"
#include "publishers.hpp"
#include "pulse.hpp"
#include "routing/forwarding.hpp"
#include "signature.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "skein/foundation/random.hpp"

namespace skein::blackboard {

/// Instance of heartbeats that are sent over relays, which do not testify to a direct link.
inline constexpr std::uint32_t kPastRelays = 1;

/// Steps for an arrival: the transport decodes it; it is lost or delayed according to the channel's
/// condition; it is checked; then states and streams pass Freshness, and events go into the session
/// of their peer.
class Blackboard::Impl {
 public:
  Impl(Config config, Transport& transport);
  /// Finds the peers in the channels and opens them.
  Result<void, Failure> open();

  Result<std::uint64_t, Refusal> send(wire::Sample sample, NodeNumber to, Now now,
                                      SendOptions options);
  Result<std::uint64_t, Refusal> publish(wire::Sample sample, Now now);
  void set_condition(NodeNumber from, NodeNumber to, const ChannelCondition& condition, Now now);
  std::vector<Incoming> receive(Now now, bool handled);
  std::vector<Incoming> act(Now now);
  std::optional<Duration> next_wakeup() const;
  std::optional<MissionTime> next_expiry() const;
  void recall_sent(wire::Sample sample, NodeNumber to, MissionTime at, SendOptions options);
  void recall_received(wire::Slot slot, const wire::SampleHeader& header);
  /// Applies `change` to a peer, as it was in a former life, and updates its due times. No effect
  /// for nodes that are no peers.
  void change(NodeNumber number, const std::function<void(Peer&)>& change);
  const Directory& directory() const { return directory_; }
  std::size_t channels() const { return config_.channels.size(); }
  const std::map<NodeNumber, MissionTime>& latest_heard() const { return latest_heard_; }

 private:
  void write(std::size_t channel, const wire::Sample& sample) {
    connections_.write(channel, sample, out_);
  }

  void arrive(Arrival&& arrival, Now now);
  void admit(std::size_t channel, wire::Sample&& sample, Now now);
  /// A sample of the world channel; `peer`: its origin, if that is one.
  void admit_published(const Peer* peer, wire::Sample&& sample, Now now);
  void admit_from_peer(std::size_t channel, Peer& peer, wire::Sample&& sample, Now now);
  void admit_heartbeat(std::size_t channel, Peer& peer, const wire::Heartbeat& heartbeat, Now now);
  void admit_part(std::size_t channel, Peer& peer, const wire::Part& part, Now now);
  Result<std::uint64_t, Refusal> send_event(Peer& peer, wire::Sample event, Now now,
                                            SendOptions options);
  void refuse_event(std::size_t channel, wire::Slot slot, const wire::SampleHeader& header,
                    Now now);
  void serve(Peer& peer, Now now);
  void write_due_events(Peer& peer, Now now);
  /// On a limited channel, as long as it is free.
  void write_in_turn(Peer& peer, Now now);
  /// Notes that samples of the peer's session came, which count as handled from the next step on.
  void hear(Peer& peer);
  /// Something new came over that channel: whoever said it is there, if it was its own.
  void show_life(std::size_t channel, const wire::SampleHeader& header, Now now);
  /// What a heartbeat says of incarnations, its sender's and of this node.
  void compare_lives(Peer& peer, const wire::Heartbeat& heartbeat, Now now);
  /// Takes this incarnation towards the peer and sends everything again.
  void become(Peer& peer, std::uint64_t incarnation, Now now);
  /// Refuses a sample that was replayed, unless it may have overtaken others on its way.
  void note_replay(std::size_t channel, wire::Slot slot, const wire::SampleHeader& header);

  // Relaying (blackboard_relaying.cpp).

  bool is_relayed(NodeNumber to) const { return forwarding_ && forwarding_->is_relayed(to); }
  /// Writes the sample on the channel to `hop`, or queues it if the channel's capacity is limited.
  void hand_to(Peer& hop, wire::Sample sample, Now now);
  void hand_all(std::vector<routing::Handed> handed, Now now);
  /// Precondition: there are relays.
  void send_on(NodeNumber to, wire::Sample sample, Now now);
  void send_past_relays(wire::Heartbeat heartbeat, Now now);
  void send_value(Peer& peer, wire::Sample sample, Now now);
  /// Updates the routes and reports changes of this node's links to other nodes.
  void route(Now now);
  void take_way(const routing::WayChange& change, Now now);

  /// Destination, slot, instance.
  using OwnStateKey = std::tuple<NodeNumber, wire::Slot, std::uint32_t>;

  Config config_;
  Transport& transport_;
  Connections connections_;
  Random losses_;
  Directory directory_;
  /// Of which the node was given something that it has not handled; may contain duplicates.
  std::vector<Peer*> heard_;
  Signature signature_;
  Pulse pulse_;  ///< on the world channel
  Publishers publishers_;
  Freshness freshness_;
  Delays delayed_;
  Drops drops_;
  /// What came from peers in the same moment as words about links: those hold first.
  std::vector<Arrival> behind_links_;
  std::vector<Incoming> out_;
  std::map<NodeNumber, MissionTime> latest_heard_;  ///< by origin
  std::optional<routing::Forwarding> forwarding_;   ///< present if there are relays
  /// The last states sent; kept only if there are relays or the incarnation is a guess. Those of
  /// the world channel have the destination kEverybody.
  std::map<OwnStateKey, wire::Sample> own_states_;
  std::set<NodeNumber> takers_for_older_;
};

}  // namespace skein::blackboard
