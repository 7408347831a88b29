// SPDX-License-Identifier: Apache-2.0
// The state of a blackboard towards one peer.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <variant>
#include <vector>

#include "heartbeat_times.hpp"
#include "line.hpp"
#include "sessions/session.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Reachability of a peer, and what is due to it. Writes nothing itself.
///
/// A heartbeat goes out each period, and at once when the channel comes up, a peer (or a new
/// incarnation of it) is first heard, or one says that it hears this node no more, so that its
/// session opens without delay; and soon after events have arrived, as their acknowledgement. A
/// heartbeat names the incarnation of the peer that is heard, or none while the peer is silent, so
/// that both notice a link that works in one direction only. A peer that has neither been heard nor
/// been sent an event has no session yet: in a large team most are never in reach.
/// Source: spec 1.3 (reachability, class event).
class Peer {
 public:
  /// The configuration and `none`, a session without content, outlive the peer.
  Peer(PeerChannels channels, const Config& config, const Session& none);

  const PeerChannels& channels() const { return line_.channels(); }
  const Line& line() const { return line_; }
  /// The session, which begins now if there is none.
  Session& session();
  /// The session as it is, or one without content.
  const Session& known() const { return session_ ? *session_ : *none_; }
  bool reachable() const { return reachable_; }
  /// The incarnation that is taken for the peer: the greatest heard, or a smaller one that goes on
  /// beside it (see Rival); 0: none.
  std::uint64_t incarnation() const { return known().lives.present().incarnation; }
  /// The incarnation of this node towards the peer.
  std::uint64_t self_incarnation() const { return known().lives.self_incarnation(); }
  /// Whether the peer has heard this node at some time of this life.
  bool was_heard() const { return was_heard_; }
  /// Towards the peer, which never heard this node, it has this incarnation from now on.
  void become(std::uint64_t incarnation, Duration now);
  /// A heartbeat of an older incarnation of the peer arrived. While the latest one is silent, the
  /// sender is told of it, since it may be a new life with too small a number, or one that goes on.
  void on_old_heartbeat(std::uint64_t incarnation, Duration now);

  void set_outgoing(const ChannelCondition& condition, Now now);
  void set_incoming(const ChannelCondition& condition);
  /// Queues a state or a stream on a channel of limited capacity, or whatever goes past a relay.
  void put(wire::Sample sample);
  /// A state to the peer is given to the transport, which keeps it: older ones need not be said.
  void pass_by(const wire::Sample& state);
  /// States that wait for room in a channel that takes no turns any more, to be written at once.
  std::vector<wire::Sample> let_go();
  /// The route to the peer has this many relays (0: direct). `heard_of`: relays connect the peer to
  /// this node. `anew`: all events are written again.
  void set_way(std::size_t relays, bool heard_of, bool anew, Now now);

  Novelty on_event(const wire::SampleHeader& header, std::optional<wire::Sample> event, Now now,
                   std::vector<Incoming>& out);
  /// It said something new in that life, with nobody in between: as long as there is contact, that
  /// goes on as with a heartbeat.
  void on_sign_of_life(std::uint64_t incarnation, Duration steady) {
    if (reachable_ && incarnation == this->incarnation())
      session().lives.present().last_heard = steady;
  }
  /// Whether samples of this incarnation are refused, because an earlier one is heard: then a
  /// second process with the peer's number says them. Notes that it does.
  bool refuses(std::uint64_t incarnation, Duration steady) {
    if (!reachable_ || !known().lives.was_refused(incarnation)) return false;
    session().lives.refused(steady);
    return true;
  }
  void on_heartbeat(const wire::Heartbeat& heartbeat, Now now, std::vector<Incoming>& out);
  /// A part of a long event of the peer arrived, or an acknowledgement of own parts. Returns the
  /// event that is complete now, or why it cannot be decoded.
  std::optional<std::variant<wire::Sample, Malformed>> on_part(const wire::Part& part, Now now,
                                                               std::vector<Incoming>& out);
  /// All delivered events count as handled.
  void commit() {
    if (session_) session_->lives.commit();
  }
  /// Detects the loss of contact and the expiry of events.
  void update(Now now, std::vector<Incoming>& out);

  // Restoration from former lives; see Blackboard and Session.
  void recall_sent(wire::Sample event, std::uint64_t receipt);
  void recall_reachable(bool reachable);

  std::vector<const wire::Sample*> take_due_events(Now now);
  bool heartbeat_due(Duration steady) const;
  /// The next heartbeat, without header; counts as sent.
  wire::Heartbeat take_heartbeat(Duration steady);
  /// The next sample to be written on a channel of limited capacity; counts as written. Heartbeats
  /// and parts are without headers.
  std::optional<wire::Sample> take_next(Now now);
  /// The next part, without header, to be written on a channel of unlimited capacity; counts as
  /// written.
  std::optional<wire::Part> take_part(Now now);
  /// The earliest expiry of the events held.
  std::optional<MissionTime> first_expiry() const {
    return recalled_ ? std::nullopt : known().first_expiry();
  }
  /// Steady time when something is next due; none if only arrivals can change that.
  std::optional<Duration> next_wakeup() const;

 private:
  /// Delivers what is in order, and owes an acknowledgement of it.
  void deliver(Now now, std::vector<Incoming>& out);
  void take_acknowledgement(const wire::Heartbeat& heartbeat, std::vector<Incoming>& out);
  /// The part to be written now: content of an own event, or an acknowledgement of what came in
  /// parts from the peer.
  std::optional<wire::Part> due_part(Now now) const;
  void part_written(const wire::Part& part, Duration until);
  /// The next part of a long state, without header; counts as written.
  wire::Part take_state_part(wire::Slot slot, Now now, Duration until);
  /// Parts are sent only while there is contact in both directions.
  bool sends_parts() const { return line_.can_send() && reachable_ && is_heard_ && !recalled_; }
  bool sends_state_parts() const {
    return line_.limited() != nullptr && !line_.is_relayed() && sends_parts() && session_;
  }

  const Config* config_;
  const Session* none_;
  std::unique_ptr<Session> session_;
  Line line_;
  bool turn_of_passing_ = false;
  bool reachable_ = false;
  bool is_heard_ = false;    ///< the peer hears this node, by its last heartbeat
  bool was_heard_ = false;   ///< the peer heard this node at some time of this life
  bool heard_old_ = false;   ///< an older incarnation since the last heartbeat to the peer
  bool is_refused_ = false;  ///< the peer takes another process for this node
  bool recalled_ = false;    ///< the peer was not heard yet since this life began
  HeartbeatTimes heartbeats_;
  std::optional<Duration> acknowledge_parts_at_;
};

using Peers = std::unordered_map<NodeNumber, Peer>;

}  // namespace skein::blackboard
