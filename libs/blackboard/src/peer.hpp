// SPDX-License-Identifier: Apache-2.0
// Everything one blackboard knows of one other node it has a channel with.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "incoming_events.hpp"
#include "incoming_parts.hpp"
#include "limited_channel.hpp"
#include "outgoing_events.hpp"
#include "outgoing_parts.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// The channels to and from a peer, as indices into Config::channels.
struct PeerChannels {
  NodeNumber number;
  ChannelKind kind = ChannelKind::kRadio;
  std::size_t outgoing = 0;
  std::size_t incoming = 0;
};

/// Reachability and both halves of the event session. Writes nothing itself: it says what is due.
///
/// A heartbeat goes out each period, and at once when the channel comes up or a peer (or a new
/// incarnation of it) is first heard, so that its session opens without waiting; soon after events
/// came in, as their acknowledgement. It says which incarnation of the peer is heard; none as long
/// as the peer is silent, so that both learn of a link that carries in one direction only. Source:
/// spec 1.3 (reachability, class event).
class Peer {
 public:
  /// The configuration outlives the peer.
  Peer(PeerChannels channels, const Config& config);

  const PeerChannels& channels() const { return channels_; }
  bool reachable() const { return reachable_; }
  /// Of the peer, the greatest heard; 0: none.
  std::uint64_t incarnation() const { return incarnation_; }
  /// Of this node, as it tells the peer.
  std::uint64_t self_incarnation() const { return self_incarnation_; }
  /// By the peer, at some time of this life.
  bool was_heard() const { return was_heard_; }
  /// To the peer, which never heard it, this node is of this incarnation from now on.
  void become(std::uint64_t incarnation, Duration now);
  /// A heartbeat of an incarnation that is not the latest one: while the peer is silent otherwise
  /// it is told so, since it may be a new life that does not know. True: the two were heard by
  /// turns, time and again, so both live.
  bool on_old_heartbeat();
  const OutgoingEvents& outgoing() const { return outgoing_; }
  const OutgoingParts& outgoing_parts() const { return parts_out_; }
  /// Whether the event goes in parts; the same in every life.
  bool is_long(const wire::Sample& event) const;
  /// To hold the event until it is acknowledged.
  bool has_room_for(const wire::Sample& event) const;
  /// That the header of the event must carry when it is held next.
  std::uint64_t next_number(const wire::Sample& event) const;
  void hold(wire::Sample event, std::uint64_t receipt);
  const ChannelCondition& outgoing_condition() const { return out_condition_; }
  const ChannelCondition& incoming_condition() const { return in_condition_; }

  void set_outgoing(const ChannelCondition& condition, Now now);
  void set_incoming(const ChannelCondition& condition) { in_condition_ = condition; }
  /// Null: the channel to the peer carries everything at once.
  LimitedChannel* limited() { return limited_.get(); }
  const LimitedChannel* limited() const { return limited_.get(); }
  /// What is sent to it goes past so many relays (0: directly); `heard_of`: there is a way from it
  /// past relays. All events are written again if `anew`.
  void set_way(std::size_t relays, bool heard_of, bool anew, Now now);

  /// Whether it had not been here before.
  bool on_event(const wire::SampleHeader& header, std::optional<wire::Sample> event, Now now,
                std::vector<Incoming>& out);
  /// It said something new in that life, with nobody in between: as long as there is contact, that
  /// goes on as with a heartbeat.
  void on_sign_of_life(std::uint64_t incarnation, Duration steady) {
    if (reachable_ && incarnation == incarnation_) last_heard_ = steady;
  }
  /// Whether the heartbeat is newer than all before it, by incarnation then sequence; then it is
  /// the newest.
  bool is_news(const wire::Heartbeat& heartbeat) {
    const std::pair version{heartbeat.header.incarnation, heartbeat.header.sequence_number};
    if (version <= newest_heartbeat_) return false;
    newest_heartbeat_ = version;
    return true;
  }
  void on_heartbeat(const wire::Heartbeat& heartbeat, Now now, std::vector<Incoming>& out);
  /// A part of a long event of the peer, or what it has of one of this node. Gives the event that
  /// is whole now, or what is wrong with it.
  std::optional<std::variant<wire::Sample, Malformed>> on_part(const wire::Part& part, Now now,
                                                               std::vector<Incoming>& out);
  /// What was let through before counts as handled.
  void commit() {
    incoming_.commit();
    parts_in_.commit();
  }
  /// Finds what has run out: contact with the peer, events.
  void update(Now now, std::vector<Incoming>& out);

  // Of a life before this one; see Blackboard.
  void recall_sent(wire::Sample event, std::uint64_t receipt);
  void recall_acknowledged(std::uint64_t number);
  void recall_given_up(std::uint64_t number);
  void recall_received(const wire::SampleHeader& header);
  void recall_reachable(bool reachable);

  std::vector<const wire::Sample*> take_due_events(Now now);
  bool heartbeat_due(Duration steady) const;
  /// The next heartbeat, but for its header; counts as sent.
  wire::Heartbeat take_heartbeat(Duration steady);
  /// What is to be written now on a limited channel, one after the other; counts as written. A
  /// heartbeat and a part are without their headers.
  std::optional<wire::Sample> take_next(Now now);
  /// A part, without its header, that is to be written now where there is no such channel; counts
  /// as written.
  std::optional<wire::Part> take_part(Now now);
  /// The last instant of the event that is held and expires first.
  std::optional<MissionTime> first_expiry() const {
    return recalled_ ? std::nullopt : earliest(outgoing_.first_expiry(), parts_out_.first_expiry());
  }
  /// Steady; none if nothing will be due by itself.
  std::optional<Duration> next_wakeup() const;

 private:
  /// What channels and acknowledgements take, beyond a time-out for everything else.
  Duration round_trip() const;
  Duration acknowledgement_delay() const;
  void owe_acknowledgement(Duration now);
  /// Of content, or what is there of the peer's.
  std::optional<wire::Part> due_part(Now now) const;
  void part_written(const wire::Part& part, Duration until);
  std::uint32_t bytes_of_a_part() const;
  /// Parts are for those with whom there is contact both ways.
  bool sends_parts() const { return can_send() && reachable_ && is_heard_ && !recalled_; }
  void limit(double capacity, Duration now);
  Duration silence_limit() const;
  /// As far as is known here.
  bool can_send() const { return relays_ > 0 || out_condition_.up; }

  PeerChannels channels_;
  const Config* config_;
  std::unique_ptr<LimitedChannel> limited_;
  std::uint64_t self_incarnation_;
  Duration period_;
  ChannelCondition out_condition_;
  ChannelCondition in_condition_;
  OutgoingEvents outgoing_;
  IncomingEvents incoming_;
  OutgoingParts parts_out_;
  IncomingParts parts_in_;
  std::size_t relays_ = 0;
  bool heard_of_ = false;
  bool turn_of_passing_ = false;
  bool reachable_ = false;
  bool is_heard_ = false;          ///< by the peer, as it said last
  bool was_heard_ = false;         ///< at some time of this life
  bool heard_old_ = false;         ///< since the last heartbeat to it
  bool heard_latest_ = false;      ///< of its latest life since one of an older
  int rival_turns_ = 0;            ///< from the latest to an older one
  bool recalled_ = false;          ///< nothing was heard of it since this life began
  std::uint64_t incarnation_ = 0;  ///< of the peer; 0: never heard
  std::pair<std::uint64_t, std::uint64_t> newest_heartbeat_;
  Duration last_heard_;
  Duration next_heartbeat_;
  std::optional<Duration> acknowledge_at_;
  std::optional<Duration> acknowledge_parts_at_;
};

using Peers = std::unordered_map<NodeNumber, Peer>;

}  // namespace skein::blackboard
