// SPDX-License-Identifier: Apache-2.0
// The blackboard of one node: slots written and read over channels. Entry header of the library.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/slot_lifespan.hpp"
#include "skein/blackboard/slot_share.hpp"
#include "skein/blackboard/transport.hpp"
#include "skein/blackboard/wire.hpp"
#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// The relays: nodes that forward samples between other nodes. Source: spec 1.3 (relaying),
/// docs/decisions/0024.
struct Relaying {
  std::set<NodeNumber> relays;  ///< of the whole system; empty: every sample goes directly
  std::size_t most_relays = 8;  ///< greatest number of relays on the way of one sample
};

struct Config {
  NodeNumber self;
  /// At least 1, and greater at each start of the node on the same mission: peers recognise a
  /// restart by it. Daemons use the wall clock in nanoseconds.
  std::uint64_t incarnation = 1;
  std::uint32_t mission = 0;
  std::vector<ChannelConfig> channels;  ///< all channels that start or end at `self`
  /// The two channels with a peer that is not in `channels`, which are added when something is sent
  /// to it or its link comes up, and are down until set_condition() says otherwise; empty: the node
  /// is no peer. So nothing is kept of who is never in reach. Null: all peers are in `channels`.
  /// Only over a transport that can add channels, and where there are no relays.
  std::function<std::vector<ChannelConfig>(NodeNumber)> channels_with = {};
  std::vector<wire::Slot> world_reads;  ///< slots of the world channel that this node reads
  Duration heartbeat_period = Duration::milliseconds(200);  ///< steady time; > 0
  /// Steady time after which an unacknowledged event is sent again; > 0.
  Duration retransmission = Duration::milliseconds(300);
  std::size_t held_events = 1024;  ///< unacknowledged, per destination; then `send` refuses
  /// Number of restarts of this incarnation with its full memory (recall_sent() and so on).
  /// Samples of a greater life count as newer than those of a smaller one.
  std::uint32_t life = 0;
  std::uint64_t seed = 0;                ///< of the random losses (ChannelCondition::loss)
  SlotShares shares = default_shares();  ///< for every channel of limited capacity
  SlotLifespans lifespans = default_lifespans();
  Relaying relaying{};
  /// No record of former incarnations was found, so `incarnation` is a guess (from a clock) and may
  /// be smaller than one that a peer has already heard. Such a peer reports the number it has
  /// heard; towards that peer this node then takes the next number and sends everything again.
  /// Nothing changes towards other peers.
  bool guesses_incarnation = false;
};

/// First sequence number of long events, which are numbered apart from other events. A long event
/// has more than 16 KiB, or more bytes than the declared capacity carries in two heartbeat periods
/// (at least 1 KiB), and its channel carries the slot Part; at most 16 MiB. It is sent in parts, so
/// that it does not delay everything else on its channel: parts have a share of their own and use
/// the capacity that other slots leave. It is delivered when it is complete: in order among long
/// events, in no order relative to other events.
inline constexpr std::uint64_t kFirstLongEvent = std::uint64_t{1} << 50U;

/// Why a sample was not sent.
enum class Refusal : std::uint8_t {
  kNoChannel,  ///< there is no channel to the destination, or it does not carry this slot
  kFull,       ///< too many unacknowledged events for this destination
  kMalformed,  ///< the sample breaks the rules of the wire
  kTooLong     ///< more than 16 MiB
};
std::string_view name_of(Refusal refusal);

struct SendOptions {
  /// Events only: the instant after which the event must not be handled any more. The lifespan of
  /// its slot (SlotLifespans) may end earlier.
  MissionTime expires = MissionTime::max();
  /// Events only: if above 0, the delivery is reported by an EventDelivered with this number.
  std::uint64_t receipt = 0;
};

/// A sample for the node: well formed, new, in order.
struct Received {
  NodeNumber origin;
  ChannelKind channel = ChannelKind::kRadio;
  wire::Sample sample;
};

/// The reachability of a peer has changed, or the peer has restarted. A peer is unreachable after
/// three heartbeat periods of silence (six while other nodes report links over which relays can
/// forward its heartbeats), and reachable again with the first heartbeat, direct or relayed.
/// `restarted`: that heartbeat is of a new incarnation (reported even if the peer never was
/// unreachable).
struct Reachability {
  NodeNumber peer;
  bool reachable = false;
  bool restarted = false;
};

/// A received sample was refused because its content is invalid.
struct Dropped {
  wire::Slot slot = wire::Slot::kHeartbeat;
  NodeNumber origin;  ///< 0 if unknown
  std::string field;
  std::string why;
  bool first = false;  ///< first one of this (slot, origin, field): worth a line in the log
};

/// An event has expired; reported by the node that found it. Reported by the sender it means that
/// no acknowledgement came in time: if contact broke meanwhile, the receiver may still have handled
/// the event.
struct EventExpired {
  wire::Slot slot = wire::Slot::kTaskEvent;
  NodeNumber from;
  NodeNumber to;
  std::uint64_t sequence = 0;
  std::uint64_t incarnation = 0;  ///< of the sender
  std::uint64_t receipt = 0;      ///< at the sender: SendOptions::receipt
  /// At the sender: the event was written while the peer was heard, so perhaps only its
  /// acknowledgement is missing. False: the peer does not have it, provided that the link works in
  /// both directions or in none.
  bool may_have_arrived = true;
};

/// At the sender: the peer has acknowledged an event that was sent with a receipt number
/// (SendOptions): its blackboard has handed it to its node, or found it expired or malformed. Each
/// event is reported at most once, by this or by EventExpired, and for one incarnation of the peer
/// in the order sent.
struct EventDelivered {
  NodeNumber to;
  std::uint64_t receipt = 0;
};

/// At the receiver: the events with sequence numbers `first` to `last` will never come, because the
/// sender gave them up (and reported each as expired, unless it stopped before).
struct EventsLost {
  NodeNumber from;
  NodeNumber to;
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::uint64_t incarnation = 0;  ///< of the sender
};

/// The transport has refused to connect or disconnect a channel (retried each heartbeat period), or
/// to write a sample. Reported once until it succeeds.
struct TransportRefused {
  ChannelConfig channel;
  std::string why;
};

/// A peer has heard a greater incarnation of this node, and so ignores this one. `is_next`: towards
/// that peer this node takes the number after `heard` from now on (Config::guesses_incarnation);
/// otherwise another process with this node's number runs, or `incarnation` is wrong. Reported once
/// for each peer.
struct TakenForOlder {
  NodeNumber peer;
  std::uint64_t heard = 0;
  bool is_next = false;
};

/// Samples to the peer take another route from now on.
struct RouteChanged {
  NodeNumber peer;
  std::optional<NodeNumber> via;  ///< the first relay on the route; none: directly
  std::size_t relays = 0;         ///< number of relays on the route
};

using Incoming = std::variant<Received, Reachability, Dropped, EventExpired, EventDelivered,
                              EventsLost, TransportRefused, RouteChanged, TakenForOlder>;

/// Sends and receives samples by the delivery classes of spec 1.3, over any Transport. Reads no
/// clock: the same calls give the same results. Laws:
/// - state: a node sees the last value of each (origin, slot, instance), never an older one after a
///   newer one; late joiners and peers that come back get it too;
/// - event: an event that one incarnation of A sends to B is handled at most once, in the order
///   sent over all event slots (long events in an order of their own: kFirstLongEvent), whatever is
///   cut, delivered twice or restarted; and exactly once if it does not expire before B has been in
///   contact for long enough. A restarted B handles the events that its former incarnation had not
///   acknowledged (so an event handled just before a crash may be handled again, by a new
///   incarnation without memory);
/// - stream: at most once, newest only;
/// - malformed content, and refusals by the transport, are reported and go no further;
/// - the laws above hold as long as links that are up connect the two nodes, directly or over
///   declared relays (Config::relaying). A sample never visits a node twice, and never takes more
///   relays than Relaying::most_relays.
/// On the world channel there are no acknowledgements: events there rely on the transport.
/// Thread rule: one thread. Source: spec 1.3.
class Blackboard {
 public:
  /// Opens the channels. The transport must outlive the blackboard.
  static Result<Blackboard, Failure> open(Config config, Transport& transport);
  Blackboard(Blackboard&&) noexcept;
  Blackboard& operator=(Blackboard&&) noexcept;
  ~Blackboard();

  /// Sends a sample to one peer. Fills in the header, except its `instance`. Returns the sequence
  /// number.
  Result<std::uint64_t, Refusal> send(wire::Sample sample, NodeNumber to, Now now,
                                      SendOptions options = {});
  /// Sends a sample to all nodes over the world channel.
  Result<std::uint64_t, Refusal> publish(wire::Sample sample, Now now);

  /// Sets the condition of a directed channel. Without effect if this node is neither of its ends.
  void set_condition(NodeNumber from, NodeNumber to, const ChannelCondition& condition, Now now);

  /// Processes arrivals and due actions (repetitions, heartbeats, expiries). Call it when the
  /// transport notifies, after each send, and at next_wakeup() and next_expiry(); at other times it
  /// has nothing to do. What it returns counts as handled by the node at the next call.
  std::vector<Incoming> step(Now now);
  /// step() in two halves, to be called one after the other: what arrived, then what is due. So a
  /// LinkState that arrived can be applied, by set_condition(), before anything more is said, and
  /// before what came from peers in the same moment: that is lost where the link is down.
  /// `handled`: whether the node has handled what the steps before returned; until it has, no event
  /// of that is acknowledged.
  std::vector<Incoming> receive(Now now, bool handled = true);
  std::vector<Incoming> act(Now now);
  /// Steady time at which step() is due even if nothing arrives.
  std::optional<Duration> next_wakeup() const;
  /// Mission time at which step() is due: an unacknowledged event expires. Cost: events held.
  std::optional<MissionTime> next_expiry() const;

  // Restoration of the sessions from the memory of former lives, so that they go on as after a cut.
  // To be called before the first step(), in the order in which things happened. Nothing is written
  // to a peer before it is heard, since its heartbeat says what it has received. Calls about nodes
  // that are no peers have no effect.

  /// An event was sent at `at`; it gets the same sequence number again. Other slots: no effect.
  void recall_sent(wire::Sample sample, NodeNumber to, MissionTime at, SendOptions options = {});
  /// The peer had acknowledged all events up to this sequence number: all long events if it is that
  /// of a long one, otherwise all others.
  void recall_acknowledged(NodeNumber peer, std::uint64_t sequence);
  /// An own event to `to` was reported as EventExpired.
  void recall_given_up(NodeNumber to, std::uint64_t sequence);
  /// A received event was handled, or reported as expired.
  void recall_received(wire::Slot slot, const wire::SampleHeader& header);
  void recall_reachable(NodeNumber peer, bool reachable);

  /// Whether there are channels with this node (yet: Config::channels_with).
  bool knows(NodeNumber peer) const;
  /// The number of channels that are open.
  std::size_t channels() const;
  /// As last reported by Reachability; false for nodes that are no peers.
  bool reachable(NodeNumber peer) const;
  /// Events sent to this peer and not acknowledged yet.
  std::size_t unacknowledged(NodeNumber peer) const;
  /// Number of states and streams to this peer that a newer value replaced before the channel had
  /// room for them; 0 for nodes that are no peers and for channels of unlimited capacity.
  std::uint64_t shed(NodeNumber peer) const;
  /// The latest mission time in the headers of well-formed samples received, by their origin.
  const std::map<NodeNumber, MissionTime>& latest_heard() const;
  /// The sequence number up to which all events to this peer are acknowledged or given up.
  std::uint64_t settled(NodeNumber peer) const;
  /// The same for long events; 0: none is.
  std::uint64_t settled_long(NodeNumber peer) const;

 private:
  class Impl;
  explicit Blackboard(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
