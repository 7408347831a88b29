// SPDX-License-Identifier: Apache-2.0
// What stands behind Blackboard.
#include "blackboard_impl.hpp"
#include "routing/path_violation.hpp"

#include <algorithm>

#include "skein/blackboard/cdr.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

/// "tasks[12].state" -> "tasks[].state": one kind, whatever the element.
std::string without_indices(const std::string& field) {
  std::string kind;
  bool inside = false;
  for (const char c : field) {
    if (c == ']') inside = false;
    if (!inside) kind.push_back(c);
    if (c == '[') inside = true;
  }
  return kind;
}

/// After its last instant that an event has expired.
constexpr Duration kTold = Duration::milliseconds(1);

/// How many states, streams and world events a life may send: two to the power of this.
constexpr int kBitsOfALife = 40;

bool is_event(wire::Slot slot) { return wire::slot_class(slot) == wire::SlotClass::kEvent; }

/// Whether it has come back to a relay. Reports are told once by their age; who has forgotten them
/// gets them again, also what it passed on.
bool is_back(wire::Slot slot, const wire::SampleHeader& header, NodeNumber self) {
  return slot != wire::Slot::kNeighbours &&
         std::ranges::find(header.via, self.value()) != header.via.end();
}

/// What every sample of the wire must have in its header, beyond the rules for all types.
std::optional<wire::Violation> header_violation(const wire::SampleHeader& header) {
  if (header.origin == 0) return wire::Violation{"header.origin", "no node has number 0"};
  if (header.incarnation == 0) return wire::Violation{"header.incarnation", "must be at least 1"};
  if (header.sequence_number == 0) {
    return wire::Violation{"header.sequence_number", "must be at least 1"};
  }
  return std::nullopt;
}

/// The peer that is the origin, which may be another than the channel's; null: the origin is none.
Peer* speaker(Peers& peers, Peer* of_channel, const wire::SampleHeader& header) {
  if (of_channel != nullptr && of_channel->channels().number.value() == header.origin)
    return of_channel;
  const auto found = peers.find(NodeNumber(header.origin));
  return found == peers.end() ? nullptr : &found->second;
}

}  // namespace

Blackboard::Impl::Impl(Config config, Transport& transport)
    : config_(std::move(config)),
      transport_(transport),
      connections_(transport, config_.channels, config_.heartbeat_period),
      losses_(config_.seed, "blackboard/losses/" + to_text(config_.self)),
      no_session_(config_),
      sequence_(std::uint64_t{config_.life} << kBitsOfALife),
      pulse_(sequence_),
      publishers_(config_),
      incarnation_(config_.incarnation) {
  SKEIN_EXPECTS(config_.self != kEverybody);
  SKEIN_EXPECTS(config_.incarnation > 0);
  SKEIN_EXPECTS(config_.heartbeat_period > Duration{});
  SKEIN_EXPECTS(config_.retransmission > Duration{});
  if (!config_.relaying.relays.empty()) forwarding_.emplace(config_);
}

Result<void, Failure> Blackboard::Impl::open() {
  for (std::size_t i = 0; i < config_.channels.size(); ++i) {
    if (auto added = add_channel(i); !added) return added;
  }
  for (const ChannelConfig& channel : config_.channels) {
    const auto found = peers_.find(channel.from);
    senders_.push_back(found == peers_.end() ? nullptr : &found->second);
  }
  return transport_.open({config_.self, config_.channels, config_.world_reads});
}

Result<void, Failure> Blackboard::Impl::add_channel(std::size_t index) {
  const ChannelConfig& channel = config_.channels[index];
  if (channel.kind == ChannelKind::kWorld) {
    if (world_) return failure("two world channels");
    world_ = index;
    if (channel.carries(wire::Slot::kHeartbeat)) pulse_.begin();
    return {};
  }
  if (channel.to == config_.self) return {};  // found from the other direction
  if (channel.from != config_.self) {
    return failure("channel " + channel.partition + " neither starts nor ends at this node");
  }
  const auto back = std::ranges::find_if(config_.channels, [&](const ChannelConfig& other) {
    return other.kind == channel.kind && other.from == channel.to && other.to == channel.from;
  });
  if (back == config_.channels.end()) return failure("no channel back for " + channel.partition);
  const auto incoming = static_cast<std::size_t>(back - config_.channels.begin());
  const PeerChannels channels{channel.to, channel.kind, index, incoming};
  const auto [added, fresh] = peers_.try_emplace(channel.to, channels, config_, no_session_);
  if (!fresh) return failure("two channels to node " + to_text(channel.to));
  plan(added->second);
  return {};
}

Peer* Blackboard::Impl::met(NodeNumber number, Now now) {
  const auto known = peers_.find(number);
  if (known != peers_.end()) return &known->second;
  if (!config_.channels_with || number == config_.self) return nullptr;
  const std::vector<ChannelConfig> added = config_.channels_with(number);
  if (added.empty()) return nullptr;
  const std::size_t first = config_.channels.size();
  for (const ChannelConfig& channel : added) {
    const auto index = transport_.add(channel);
    SKEIN_ENSURES(index == config_.channels.size());
    config_.channels.push_back(channel);
  }
  for (std::size_t i = first; i < config_.channels.size(); ++i)
    SKEIN_ENSURES(add_channel(i).has_value());
  Peer& peer = peers_.at(number);
  for (const ChannelConfig& channel : added)
    senders_.push_back(channel.from == number ? &peer : nullptr);
  const ChannelCondition down{.up = false, .latency = {}};
  peer.set_outgoing(down, now);
  peer.set_incoming(down);
  plan(peer);
  return &peer;
}

const Peer* Blackboard::Impl::peer(NodeNumber number) const {
  const auto found = peers_.find(number);
  return found == peers_.end() ? nullptr : &found->second;
}

void Blackboard::Impl::stamp(wire::SampleHeader& header, NodeNumber to, std::uint64_t sequence,
                             Now now) const {
  header.origin = config_.self.value();
  header.destination = to.value();
  const auto found = config_.guesses_incarnation ? peers_.find(to) : peers_.end();
  header.incarnation = found == peers_.end() ? incarnation_ : found->second.self_incarnation();
  header.sequence_number = sequence;
  header.mission_time = now.mission.count();
  header.expires = wire::kNever;
  header.mission = config_.mission;
}

Result<std::uint64_t, Refusal> Blackboard::Impl::send(wire::Sample sample, NodeNumber to, Now now,
                                                      SendOptions options) {
  Peer* found = met(to, now);
  const wire::Slot slot = wire::slot_of(sample);
  if (found == nullptr || !config_.channels[found->channels().outgoing].originates(slot)) {
    return tl::unexpected(Refusal::kNoChannel);
  }
  if (wire::find_violation(sample)) return tl::unexpected(Refusal::kMalformed);
  Peer& peer = *found;
  if (is_event(slot)) return send_event(peer, std::move(sample), now, options);
  stamp(wire::header_of(sample), to, ++sequence_, now);
  const std::uint64_t sequence_of_value = sequence_;
  send_value(peer, std::move(sample), now);
  return sequence_of_value;
}

Result<std::uint64_t, Refusal> Blackboard::Impl::send_event(Peer& peer, wire::Sample event, Now now,
                                                            SendOptions options) {
  if (!peer.has_room_for(event)) return tl::unexpected(Refusal::kFull);
  if (peer.is_long(event) && encoded_size(event) > IncomingParts::kLongest)
    return tl::unexpected(Refusal::kTooLong);
  address(event, peer, options.expires, now);
  const std::uint64_t sequence = wire::header_of(event).sequence_number;
  peer.hold(std::move(event), options.receipt);
  write_due_events(peer, now);
  plan(peer);
  return sequence;
}

void Blackboard::Impl::address(wire::Sample& event, const Peer& peer, MissionTime expires,
                               Now now) const {
  wire::SampleHeader& header = wire::header_of(event);
  stamp(header, peer.channels().number, peer.next_number(event), now);
  header.expires = expiry_of(wire::slot_of(event), config_.lifespans, now.mission, expires).count();
}

void Blackboard::Impl::write_due_events(Peer& peer, Now now) {
  const NodeNumber to = peer.channels().number;
  const bool relayed = is_relayed(to);
  if (!relayed && peer.limited() != nullptr) return write_in_turn(peer, now);
  const auto write_one = [&](const wire::Sample& sample) {
    relayed ? send_on(to, sample, now) : write(peer.channels().outgoing, sample);
  };
  for (const wire::Sample* event : peer.take_due_events(now)) write_one(*event);
  while (auto part = peer.take_part(now)) {
    stamp(part->header, to, ++sequence_, now);
    write_one(*part);
  }
}

void Blackboard::Impl::write_in_turn(Peer& peer, Now now) {
  while (auto next = peer.take_next(now)) {
    wire::SampleHeader& header = wire::header_of(*next);
    if (header.origin == 0) {
      stamp(header, peer.channels().number, ++sequence_, now);
      const auto* heartbeat = std::get_if<wire::Heartbeat>(&*next);
      if (heartbeat != nullptr) send_past_relays(*heartbeat, now);
    }
    write(peer.channels().outgoing, *next);
  }
}

Result<std::uint64_t, Refusal> Blackboard::Impl::publish(wire::Sample sample, Now now) {
  if (!world_ || !config_.channels[*world_].carries(wire::slot_of(sample))) {
    return tl::unexpected(Refusal::kNoChannel);
  }
  if (wire::find_violation(sample)) return tl::unexpected(Refusal::kMalformed);
  stamp(wire::header_of(sample), kEverybody, ++sequence_, now);
  const wire::Slot slot = wire::slot_of(sample);
  if (config_.guesses_incarnation && wire::slot_class(slot) == wire::SlotClass::kState)
    own_states_.insert_or_assign(OwnStateKey{kEverybody, slot, wire::header_of(sample).instance},
                                 sample);
  write(*world_, sample);
  return sequence_;
}

void Blackboard::Impl::recall_sent(wire::Sample sample, NodeNumber to, MissionTime at,
                                   SendOptions options) {
  const wire::Slot slot = wire::slot_of(sample);
  Peer* found = is_event(slot) ? met(to, {at, {}}) : nullptr;
  if (found == nullptr) return;
  if (!config_.channels[found->channels().outgoing].originates(slot) ||
      wire::find_violation(sample))
    return;
  Peer& peer = *found;
  address(sample, peer, options.expires, {at, {}});
  peer.recall_sent(std::move(sample), options.receipt);
  plan(peer);
}

void Blackboard::Impl::recall_received(wire::Slot slot, const wire::SampleHeader& header) {
  Peer* found = met(NodeNumber(header.origin), {});
  if (found == nullptr) return;
  if (is_event(slot)) {
    found->recall_received(header);
  } else if (slot != wire::Slot::kHeartbeat) {
    freshness_.admit(slot, header);
  }
}

void Blackboard::Impl::set_condition(NodeNumber from, NodeNumber to,
                                     const ChannelCondition& condition, Now now) {
  const bool outgoing = from == config_.self;
  if (!outgoing && to != config_.self) return;
  const NodeNumber number = outgoing ? to : from;
  if (!condition.up && !peers_.contains(number)) return;
  Peer* found = met(number, now);
  if (found == nullptr) return;
  Peer& peer = *found;
  if (outgoing) {
    const bool changes = condition.up != peer.outgoing_condition().up;
    if (changes && !condition.up) {
      connections_.set_up(peer.channels().outgoing, false, now.steady, out_);
    }
    const auto let_go = [&] {
      for (const wire::Sample& state : peer.let_go()) write(peer.channels().outgoing, state);
    };
    if (peer.limited() != nullptr && condition.up && condition.capacity <= 0) let_go();
    peer.set_outgoing(condition, now);
    if (changes && condition.up) {
      connections_.set_up(peer.channels().outgoing, true, now.steady, out_);
    }
    if (condition.up && peer.limited() == nullptr) let_go();
    serve(peer, now);
  } else {
    const bool changes = condition.up != peer.incoming_condition().up;
    if (peer.incoming_condition().capacity > 0 && !condition.up)
      delayed_.cut(peer.channels().incoming, now.steady);
    peer.set_incoming(condition);
    if (changes) connections_.set_up(peer.channels().incoming, condition.up, now.steady, out_);
    plan(peer);
  }
}

void Blackboard::Impl::serve(Peer& peer, Now now) {
  write_due_events(peer, now);
  const bool takes_turns = peer.limited() != nullptr && peer.outgoing_condition().up;
  if (takes_turns) write_in_turn(peer, now);
  if (!takes_turns && peer.heartbeat_due(now.steady)) {
    wire::Heartbeat heartbeat = peer.take_heartbeat(now.steady);
    stamp(heartbeat.header, peer.channels().number, ++sequence_, now);
    if (peer.outgoing_condition().up) write(peer.channels().outgoing, heartbeat);
    send_past_relays(heartbeat, now);
  }
  plan(peer);
}

void Blackboard::Impl::change(NodeNumber number, const std::function<void(Peer&)>& change) {
  Peer* found = met(number, {});
  if (found == nullptr) return;
  change(*found);
  plan(*found);
}

void Blackboard::Impl::plan(const Peer& peer) {
  agenda_.set(peer.channels().number, peer.next_wakeup(), peer.first_expiry());
}

std::optional<Duration> Blackboard::Impl::next_wakeup() const {
  std::optional<Duration> next = delayed_.next_due();
  const auto sooner = [&](std::optional<Duration> due) {
    if (due && (!next || *due < *next)) next = due;
  };
  sooner(agenda_.next_due());
  sooner(connections_.next_due());
  sooner(pulse_.next());
  if (forwarding_) sooner(forwarding_->next_wakeup());
  return next;
}

std::optional<MissionTime> Blackboard::Impl::next_expiry() const {
  const auto first = agenda_.next_expiry();
  if (!first) return std::nullopt;
  return *first + kTold;
}

void Blackboard::Impl::arrive(Arrival&& arrival, Now now) {
  if (const auto* malformed = std::get_if<Malformed>(&arrival.content)) {
    refuse(malformed->slot, malformed->header, malformed->violation);
    refuse_event(arrival.channel, malformed->slot, malformed->header, now);
    return;
  }
  auto& sample = std::get<wire::Sample>(arrival.content);
  if (wire::header_of(sample).origin == config_.self.value()) return;  // shared partition: our own
  const Peer* from = senders_[arrival.channel];
  if (from == nullptr) return admit(arrival.channel, std::move(sample), now);
  const ChannelCondition& condition = from->incoming_condition();
  if (wire::slot_class(wire::slot_of(sample)) == wire::SlotClass::kStream && condition.loss > 0 &&
      losses_.chance(condition.loss)) {
    return;
  }
  Duration transmitted = now.steady;
  if (condition.capacity > 0)
    transmitted = transmitted + airtime(channel_bytes(sample), condition.capacity);
  delayed_.add(arrival.channel, std::move(sample), transmitted, condition.latency);
}

void Blackboard::Impl::admit(std::size_t channel, wire::Sample&& sample, Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const wire::SampleHeader header = wire::header_of(sample);
  auto violation = wire::find_violation(sample);
  if (!violation) violation = header_violation(header);
  const ChannelConfig& config = config_.channels[channel];
  const bool world = config.kind == ChannelKind::kWorld;
  if (!violation && !world) {
    violation =
        routing::path_violation({config_, peers_, forwarding_.has_value()}, config, slot, header);
  }
  if (violation) {
    refuse(slot, header, *violation);
    return refuse_event(channel, slot, header, now);
  }
  if (is_back(slot, header, config_.self)) return;
  Peer* origin = speaker(peers_, senders_[channel], header);
  if (origin != nullptr && origin->refuses(header.incarnation, now.steady))
    return refuse(wire::Slot::kHeartbeat, header, kOfSecond);
  if (header.destination != 0 && header.destination != config_.self.value()) {
    if (!forwarding_) return;
    if (auto next = forwarding_->pass_on(config, std::move(sample)))
      hand_to(peers_.at(next->hop), std::move(next->sample), now);
    return;
  }
  latest_heard_ = std::max(latest_heard_, MissionTime::nanoseconds(header.mission_time));
  if (world) return admit_published(origin, std::move(sample), now);
  admit_from_peer(channel, *origin, std::move(sample), now);
}

void Blackboard::Impl::admit_from_peer(std::size_t channel, Peer& peer, wire::Sample&& sample,
                                       Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const wire::SampleHeader header = wire::header_of(sample);
  if (const auto* heartbeat = std::get_if<wire::Heartbeat>(&sample))
    return admit_heartbeat(channel, peer, *heartbeat, now);
  if (header.incarnation < peer.incarnation() && !peer.lives().is_former(header.incarnation))
    return peer.has_older_rival() ? refuse(wire::Slot::kHeartbeat, header, kOfOlderSecond)
                                  : note_replay(channel, slot, header);
  if (header.incarnation < peer.incarnation() && !is_event(slot)) return;
  const Novelty novelty = is_event(slot) ? peer.on_event(header, std::move(sample), now, out_)
                                         : freshness_.admit(slot, header);
  if (novelty == Novelty::kNew) show_life(channel, header, now);
  if (novelty == Novelty::kReplayed) note_replay(channel, slot, header);
  if (is_event(slot)) return hear(peer);
  if (novelty != Novelty::kNew) return;
  if (const auto* part = std::get_if<wire::Part>(&sample))
    return admit_part(channel, peer, *part, now);
  if (auto* report = std::get_if<wire::Neighbours>(&sample)) {
    if (forwarding_) hand_all(forwarding_->learn(std::move(*report)), now);
    return;
  }
  out_.emplace_back(Received{NodeNumber(header.origin), peer.channels().kind, std::move(sample)});
}

void Blackboard::Impl::admit_heartbeat(std::size_t channel, Peer& peer,
                                       const wire::Heartbeat& heartbeat, Now now) {
  const ChannelConfig& over = config_.channels[channel];
  compare_lives(peer, heartbeat, now);
  const Novelty novelty = peer.note(heartbeat);
  if (novelty == Novelty::kReplayed)
    return note_replay(channel, wire::Slot::kHeartbeat, heartbeat.header);
  if (novelty == Novelty::kKnown) return;
  if (forwarding_ && heartbeat.header.via.empty() && over.kind == ChannelKind::kRadio)
    forwarding_->on_heartbeat(over.from, now.steady);
  const std::uint64_t before = peer.incarnation();
  const bool was_refused = peer.lives().was_refused(heartbeat.header.incarnation);
  peer.on_heartbeat(heartbeat, now, out_);
  const bool is_first_again = peer.incarnation() < before;
  if (is_first_again) {  // of two processes with its number
    refuse(wire::Slot::kHeartbeat, heartbeat.header, kOfSecond);
    freshness_.return_to(heartbeat.header.origin, peer.incarnation());
    if (forwarding_) forwarding_->forget(peer.channels().number);
  }
  if ((is_first_again || was_refused) && peer.incoming_condition().up)
    connections_.set_up_anew(peer.channels().incoming, now.steady, out_);
  hear(peer);
}

void Blackboard::Impl::refuse(wire::Slot slot, const wire::SampleHeader& header,
                              const wire::Violation& violation) {
  const NodeNumber origin(header.origin);
  const DropKey kind{slot, origin, without_indices(violation.field)};
  const auto count = drops_.count(kind);
  out_.emplace_back(Dropped{slot, origin, violation.field, violation.why + count.value_or(""),
                            count.has_value()});
}

/// A malformed event still has its place in the sequence: what follows it must not wait.
void Blackboard::Impl::refuse_event(std::size_t channel, wire::Slot slot,
                                    const wire::SampleHeader& header, Now now) {
  if (!is_event(slot) || header_violation(header)) return;
  Peer* from = senders_[channel];
  if (from == nullptr || header.origin != from->channels().number.value()) return;
  if (!header.via.empty()) return;
  if (header.destination != config_.self.value()) return;
  from->on_event(header, std::nullopt, now, out_);
  hear(*from);
}

void Blackboard::Impl::show_life(std::size_t channel, const wire::SampleHeader& header, Now now) {
  const ChannelConfig& over = config_.channels[channel];
  if (over.from.value() != header.origin || !header.via.empty() || senders_[channel] == nullptr)
    return;
  senders_[channel]->on_sign_of_life(header.incarnation, now.steady);
  if (forwarding_ && over.kind == ChannelKind::kRadio)
    forwarding_->on_sign_of_life(over.from, now.steady);
}

void Blackboard::Impl::hear(Peer& peer) {
  if (heard_.empty() || heard_.back() != &peer) heard_.push_back(&peer);
  plan(peer);
}

}  // namespace skein::blackboard
