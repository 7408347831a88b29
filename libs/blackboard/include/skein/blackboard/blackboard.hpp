// SPDX-License-Identifier: Apache-2.0
// The blackboard of one node: slots written and read over channels. Entry header of the library.
#pragma once

#include <cstdint>
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

/// Who passes on what is not for him. Source: spec 1.3 (relaying), docs/decisions/0024.
struct Relaying {
  std::set<NodeNumber> relays;  ///< of the whole system; none: everything goes directly
  std::size_t most_relays = 8;  ///< that a sample may pass
};

struct Config {
  NodeNumber self;
  /// Greater at each start of the node on the same mission, at least 1: that is how others see a
  /// restart. A daemon takes the wall clock in nanoseconds.
  std::uint64_t incarnation = 1;
  std::uint32_t mission = 0;
  std::vector<ChannelConfig> channels;  ///< all that start or end at `self`
  std::vector<wire::Slot> world_reads;
  Duration heartbeat_period = Duration::milliseconds(200);  ///< steady; > 0
  /// Steady; how long an event waits for its acknowledgement before it is sent again; > 0.
  Duration retransmission = Duration::milliseconds(300);
  std::size_t held_events = 1024;  ///< unacknowledged, per destination; then `send` refuses
  /// Which life of this incarnation this is: 0, or more if the node was restarted with all it knew.
  /// What it sends now then counts as newer than what it sent before.
  std::uint32_t life = 0;
  std::uint64_t seed = 0;                ///< of the losses
  SlotShares shares = default_shares();  ///< of every channel whose capacity is limited
  SlotLifespans lifespans = default_lifespans();
  Relaying relaying{};
  /// Nothing told of former lives: `incarnation` is a guess (of a clock), which may be smaller than
  /// one that peers have heard. A peer that has tells so; to it this node then is the next one
  /// after that. Everything said to that peer is said again, to others nothing changes.
  bool guesses_incarnation = false;
};

/// Long events are numbered from here on, apart from the others: those that would hold up
/// everything else on their channel go in parts (slot Part), which take what the rest leaves and a
/// share of their own. Such an event comes when it is whole: in the order of long events, and in
/// none with others. It is one of more than 16 KiB, or of more than the declared capacity carries
/// in two heartbeat periods (1 KiB at least), over a channel that carries parts. At most 16 MiB.
inline constexpr std::uint64_t kFirstLongEvent = std::uint64_t{1} << 50U;

/// Why a sample was not sent.
enum class Refusal : std::uint8_t {
  kNoChannel,  ///< to the destination, or not for this slot
  kFull,       ///< too many unacknowledged events for this destination
  kMalformed,  ///< the sample breaks the rules of the wire
  kTooLong     ///< more than 16 MiB
};
std::string_view name_of(Refusal refusal);

struct SendOptions {
  /// Events: the instant after which it must not be handled any more; the lifespan of its slot may
  /// end before.
  MissionTime expires = MissionTime::max();
  /// Events: above 0, the sender is told by EventDelivered, with this number, that it arrived.
  std::uint64_t receipt = 0;
};

/// A sample handed to the node: well formed, new, in order.
struct Received {
  NodeNumber origin;
  ChannelKind channel = ChannelKind::kRadio;
  wire::Sample sample;
};

/// What this node believes of a peer: gone after three silent heartbeat periods (six, while others
/// tell that there is a way from it past relays), back with the first heartbeat heard, directly or
/// past relays. `restarted`: the peer heard is a new incarnation of the one heard before
/// (then reported even if it was never missed).
struct Reachability {
  NodeNumber peer;
  bool reachable = false;
  bool restarted = false;
};

/// Content that was refused at the boundary.
struct Dropped {
  wire::Slot slot = wire::Slot::kHeartbeat;
  NodeNumber origin;  ///< 0 if unknown
  std::string field;
  std::string why;
  bool first = false;  ///< of this (slot, origin, field): worth a line in the log
};

/// An event that was too late; reported where that was found. At the sender it means that no
/// acknowledgement came in time: if contact broke in between, it may have been handled all the
/// same.
struct EventExpired {
  wire::Slot slot = wire::Slot::kTaskEvent;
  NodeNumber from;
  NodeNumber to;
  std::uint64_t sequence = 0;
  std::uint64_t incarnation = 0;  ///< of the sender
  std::uint64_t receipt = 0;      ///< at the sender, that it asked for (SendOptions)
  /// At the sender: it went out while the peer was heard, so that only its acknowledgement may be
  /// missing. False: over a link that carries in both directions or not at all, nobody has it.
  bool may_have_arrived = true;
};

/// At the sender: the peer has acknowledged an event whose sender asked to be told (SendOptions).
/// Its blackboard has given it out, or found it too late or malformed; each event is reported at
/// most once, as this or as EventExpired, and of one incarnation of the peer in the order sent.
struct EventDelivered {
  NodeNumber to;
  std::uint64_t receipt = 0;
};

/// Events that the receiver will never see because the sender gave them up (it reported them as
/// expired, if it lived to do so): sequence numbers first to last.
struct EventsLost {
  NodeNumber from;
  NodeNumber to;
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::uint64_t incarnation = 0;  ///< of the sender
};

/// The transport refuses something: to connect or disconnect the channel, which is asked for again
/// each heartbeat period, or a sample. Reported once until it is granted.
struct TransportRefused {
  ChannelConfig channel;
  std::string why;
};

/// A peer has heard a greater incarnation of this node, and so does not hear this one. `is_next`:
/// to it this node is the one after that from now on (Config::guesses_incarnation); else the other
/// one lives, or this one has the wrong number. Reported once for each peer.
struct TakenForOlder {
  NodeNumber peer;
  std::uint64_t heard = 0;
  bool is_next = false;
};

/// What is sent to the peer goes another way from now on.
struct RouteChanged {
  NodeNumber peer;
  std::optional<NodeNumber> via;  ///< the first relay on the way; none: directly
  std::size_t relays = 0;         ///< on the way altogether
};

using Incoming = std::variant<Received, Reachability, Dropped, EventExpired, EventDelivered,
                              EventsLost, TransportRefused, RouteChanged, TakenForOlder>;

/// Sends and receives by the delivery classes of spec 1.3, over any Transport. Time is given; the
/// same calls give the same results. Laws:
/// - state: a node sees the last value of each (origin, slot, instance), never an older one after a
///   newer one; late joiners and peers that come back get it too;
/// - event: what one incarnation of A sends to B is handled at most once, in the order sent over
///   all event slots (long events in an order of their own: kFirstLongEvent), whatever is cut,
///   delivered twice or restarted; and exactly once if B lives long enough in contact and it has
///   not expired. A restarted B handles what the one before had not acknowledged (an event handled
///   just before a crash may therefore be handled again by the next incarnation, which knows
///   nothing of it);
/// - stream: at most once, newest only;
/// - malformed content is reported and goes no further; so is what the transport refuses;
/// - all of this holds for as long as there is a way over links that are up from one to the other
///   past those who are declared relays (Config::relaying). A sample never passes a node twice, nor
///   more relays than declared.
/// On the world channel there are no acknowledgements: events there rely on the transport.
/// Thread rule: one thread. Source: spec 1.3.
class Blackboard {
 public:
  /// Opens the channels. The transport must outlive the blackboard.
  static Result<Blackboard, Failure> open(Config config, Transport& transport);
  Blackboard(Blackboard&&) noexcept;
  Blackboard& operator=(Blackboard&&) noexcept;
  ~Blackboard();

  /// Sends to one peer over the channel to it. The header is stamped here, except its `instance`.
  /// Gives the sequence number.
  Result<std::uint64_t, Refusal> send(wire::Sample sample, NodeNumber to, Now now,
                                      SendOptions options = {});
  /// Sends to everybody over the world channel.
  Result<std::uint64_t, Refusal> publish(wire::Sample sample, Now now);

  /// Sets the condition of the directed channel; without effect on a channel that this node has no
  /// end of.
  void set_condition(NodeNumber from, NodeNumber to, const ChannelCondition& condition, Now now);

  /// Takes what has arrived and does what is due. To call when the transport notifies, after
  /// anything was sent, and at next_wakeup() and next_expiry(): in between it does nothing. What it
  /// gives counts as handled at the next call.
  std::vector<Incoming> step(Now now);
  /// Steady time at which step() is due even if nothing arrives.
  std::optional<Duration> next_wakeup() const;
  /// Likewise in mission time: when an event expires that is not acknowledged. Cost: events held.
  std::optional<MissionTime> next_expiry() const;

  // What the lives before this one did, in the order in which they did it and before the first
  // step(), so that its sessions go on as if there had been a cut. Nothing is written before the
  // peer is heard: it says what it had. Strangers are disregarded.

  /// An event was sent at `at`; it gets the sequence number that it had. Other slots: nothing.
  void recall_sent(wire::Sample sample, NodeNumber to, MissionTime at, SendOptions options = {});
  /// The peer had handled everything up to this one, of long events or of the others.
  void recall_acknowledged(NodeNumber peer, std::uint64_t sequence);
  /// Reported as EventExpired at its sender.
  void recall_given_up(NodeNumber to, std::uint64_t sequence);
  /// Handled, or reported as too late.
  void recall_received(wire::Slot slot, const wire::SampleHeader& header);
  void recall_reachable(NodeNumber peer, bool reachable);

  /// As last reported by Reachability; false for strangers.
  bool reachable(NodeNumber peer) const;
  /// Events sent to this peer and not acknowledged yet.
  std::size_t unacknowledged(NodeNumber peer) const;
  /// States and streams for this peer that a newer value took the place of before the channel had
  /// room for them; 0 for strangers and channels that are not limited.
  std::uint64_t shed(NodeNumber peer) const;
  /// The latest mission time that any peer wrote into what was well formed.
  MissionTime latest_heard() const;
  /// Up to this one all events sent to this peer are acknowledged or given up.
  std::uint64_t settled(NodeNumber peer) const;
  /// Likewise of long events; 0: none is.
  std::uint64_t settled_long(NodeNumber peer) const;

 private:
  class Impl;
  explicit Blackboard(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
