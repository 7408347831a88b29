// SPDX-License-Identifier: Apache-2.0
// What stands behind Blackboard.
#include "blackboard_impl.hpp"
#include "routing/path_violation.hpp"

#include <algorithm>

#include "skein/blackboard/cdr.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

/// After its last instant that an event has expired.
constexpr Duration kTold = Duration::milliseconds(1);

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

}  // namespace

Blackboard::Impl::Impl(Config config, Transport& transport)
    : config_(std::move(config)),
      transport_(transport),
      connections_(transport, config_.channels, config_.heartbeat_period),
      losses_(config_.seed, "blackboard/losses/" + to_text(config_.self)),
      directory_(config_, transport),
      signature_(config_),
      pulse_(signature_.last_number()),
      publishers_(config_) {
  SKEIN_EXPECTS(config_.self != kEverybody);
  SKEIN_EXPECTS(config_.incarnation > 0);
  SKEIN_EXPECTS(config_.heartbeat_period > Duration{});
  SKEIN_EXPECTS(config_.retransmission > Duration{});
  if (!config_.relaying.relays.empty()) forwarding_.emplace(config_);
}

Result<void, Failure> Blackboard::Impl::open() {
  if (auto opened = directory_.open(); !opened) return opened;
  const auto world = directory_.world();
  if (world && config_.channels[*world].carries(wire::Slot::kHeartbeat)) pulse_.begin();
  return transport_.open({config_.self, config_.channels, config_.world_reads});
}

Result<std::uint64_t, Refusal> Blackboard::Impl::send(wire::Sample sample, NodeNumber to, Now now,
                                                      SendOptions options) {
  Peer* found = directory_.meet(to, now);
  const wire::Slot slot = wire::slot_of(sample);
  if (found == nullptr || !config_.channels[found->channels().outgoing].originates(slot)) {
    return tl::unexpected(Refusal::kNoChannel);
  }
  if (wire::find_violation(sample)) return tl::unexpected(Refusal::kMalformed);
  Peer& peer = *found;
  if (is_event(slot)) return send_event(peer, std::move(sample), now, options);
  const std::uint64_t sequence = signature_.sign(wire::header_of(sample), peer, now);
  send_value(peer, std::move(sample), now);
  return sequence;
}

Result<std::uint64_t, Refusal> Blackboard::Impl::send_event(Peer& peer, wire::Sample event, Now now,
                                                            SendOptions options) {
  const bool is_long = peer.line().is_long_event(event);
  if (peer.known().full(is_long)) return tl::unexpected(Refusal::kFull);
  if (is_long && encoded_size(event) > IncomingParts::kLongest)
    return tl::unexpected(Refusal::kTooLong);
  signature_.sign_event(event, peer, options.expires, now);
  const std::uint64_t sequence = wire::header_of(event).sequence_number;
  peer.session().hold(std::move(event), options.receipt);
  write_due_events(peer, now);
  directory_.plan(peer);
  return sequence;
}

void Blackboard::Impl::write_due_events(Peer& peer, Now now) {
  const NodeNumber to = peer.channels().number;
  const bool relayed = is_relayed(to);
  if (!relayed && peer.line().limited() != nullptr) return write_in_turn(peer, now);
  const auto write_one = [&](const wire::Sample& sample) {
    relayed ? send_on(to, sample, now) : write(peer.channels().outgoing, sample);
  };
  for (const wire::Sample* event : peer.take_due_events(now)) write_one(*event);
  while (auto part = peer.take_part(now)) {
    signature_.sign(part->header, peer, now);
    write_one(*part);
  }
}

void Blackboard::Impl::write_in_turn(Peer& peer, Now now) {
  while (auto next = peer.take_next(now)) {
    wire::SampleHeader& header = wire::header_of(*next);
    if (header.origin == 0) {
      signature_.sign(header, peer, now);
      const auto* heartbeat = std::get_if<wire::Heartbeat>(&*next);
      if (heartbeat != nullptr) send_past_relays(*heartbeat, now);
    }
    write(peer.channels().outgoing, *next);
  }
}

Result<std::uint64_t, Refusal> Blackboard::Impl::publish(wire::Sample sample, Now now) {
  if (!directory_.world() ||
      !config_.channels[*directory_.world()].carries(wire::slot_of(sample))) {
    return tl::unexpected(Refusal::kNoChannel);
  }
  if (wire::find_violation(sample)) return tl::unexpected(Refusal::kMalformed);
  const std::uint64_t sequence = signature_.sign_published(wire::header_of(sample), now);
  const wire::Slot slot = wire::slot_of(sample);
  if (config_.guesses_incarnation && wire::slot_class(slot) == wire::SlotClass::kState)
    own_states_.insert_or_assign(OwnStateKey{kEverybody, slot, wire::header_of(sample).instance},
                                 sample);
  write(*directory_.world(), sample);
  return sequence;
}

void Blackboard::Impl::recall_sent(wire::Sample sample, NodeNumber to, MissionTime at,
                                   SendOptions options) {
  const wire::Slot slot = wire::slot_of(sample);
  Peer* found = is_event(slot) ? directory_.meet(to, {at, {}}) : nullptr;
  if (found == nullptr) return;
  if (!config_.channels[found->channels().outgoing].originates(slot) ||
      wire::find_violation(sample))
    return;
  Peer& peer = *found;
  signature_.sign_event(sample, peer, options.expires, {at, {}});
  peer.recall_sent(std::move(sample), options.receipt);
  directory_.plan(peer);
}

void Blackboard::Impl::recall_received(wire::Slot slot, const wire::SampleHeader& header) {
  Peer* found = directory_.meet(NodeNumber(header.origin), {});
  if (found == nullptr) return;
  if (is_event(slot)) {
    found->session().recall_received(header);
  } else if (slot != wire::Slot::kHeartbeat) {
    freshness_.admit(slot, header);
  }
}

void Blackboard::Impl::set_condition(NodeNumber from, NodeNumber to,
                                     const ChannelCondition& condition, Now now) {
  const bool outgoing = from == config_.self;
  if (!outgoing && to != config_.self) return;
  const NodeNumber number = outgoing ? to : from;
  if (!condition.up && directory_.find(number) == nullptr) return;
  Peer* found = directory_.meet(number, now);
  if (found == nullptr) return;
  Peer& peer = *found;
  if (outgoing) {
    const bool changes = condition.up != peer.line().outgoing().up;
    if (changes && !condition.up) {
      connections_.set_up(peer.channels().outgoing, false, now.steady, out_);
    }
    const auto let_go = [&] {
      for (const wire::Sample& state : peer.let_go()) write(peer.channels().outgoing, state);
    };
    if (peer.line().limited() != nullptr && condition.up && condition.capacity <= 0) let_go();
    peer.set_outgoing(condition, now);
    if (changes && condition.up) {
      connections_.set_up(peer.channels().outgoing, true, now.steady, out_);
    }
    if (condition.up && peer.line().limited() == nullptr) let_go();
    serve(peer, now);
  } else {
    const bool changes = condition.up != peer.line().incoming().up;
    if (peer.line().incoming().capacity > 0 && !condition.up)
      delayed_.cut(peer.channels().incoming, now.steady);
    peer.set_incoming(condition);
    if (changes) connections_.set_up(peer.channels().incoming, condition.up, now.steady, out_);
    directory_.plan(peer);
  }
}

void Blackboard::Impl::serve(Peer& peer, Now now) {
  write_due_events(peer, now);
  const bool takes_turns = peer.line().limited() != nullptr && peer.line().outgoing().up;
  if (takes_turns) write_in_turn(peer, now);
  if (!takes_turns && peer.heartbeat_due(now.steady)) {
    wire::Heartbeat heartbeat = peer.take_heartbeat(now.steady);
    signature_.sign(heartbeat.header, peer, now);
    if (peer.line().outgoing().up) write(peer.channels().outgoing, heartbeat);
    send_past_relays(heartbeat, now);
  }
  directory_.plan(peer);
}

void Blackboard::Impl::change(NodeNumber number, const std::function<void(Peer&)>& change) {
  Peer* found = directory_.meet(number, {});
  if (found == nullptr) return;
  change(*found);
  directory_.plan(*found);
}

std::optional<Duration> Blackboard::Impl::next_wakeup() const {
  std::optional<Duration> next = delayed_.next_due();
  const auto sooner = [&](std::optional<Duration> due) {
    if (due && (!next || *due < *next)) next = due;
  };
  sooner(directory_.agenda().next_due());
  sooner(connections_.next_due());
  sooner(pulse_.next());
  if (forwarding_) sooner(forwarding_->next_wakeup());
  return next;
}

std::optional<MissionTime> Blackboard::Impl::next_expiry() const {
  const auto first = directory_.agenda().next_expiry();
  if (!first) return std::nullopt;
  return *first + kTold;
}

void Blackboard::Impl::arrive(Arrival&& arrival, Now now) {
  if (const auto* malformed = std::get_if<Malformed>(&arrival.content)) {
    drops_.tell(malformed->slot, malformed->header, malformed->violation, out_);
    refuse_event(arrival.channel, malformed->slot, malformed->header, now);
    return;
  }
  auto& sample = std::get<wire::Sample>(arrival.content);
  if (wire::header_of(sample).origin == config_.self.value()) return;  // shared partition: our own
  const Peer* from = directory_.over(arrival.channel);
  if (from == nullptr) return admit(arrival.channel, std::move(sample), now);
  const ChannelCondition& condition = from->line().incoming();
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
    violation = routing::path_violation({config_, directory_.all(), forwarding_.has_value()},
                                        config, slot, header);
  }
  if (violation) {
    drops_.tell(slot, header, *violation, out_);
    return refuse_event(channel, slot, header, now);
  }
  if (is_back(slot, header, config_.self)) return;
  Peer* origin = directory_.origin(channel, header);
  if (origin != nullptr && origin->refuses(header.incarnation, now.steady))
    return drops_.tell(wire::Slot::kHeartbeat, header, kOfSecond, out_);
  if (header.destination != 0 && header.destination != config_.self.value()) {
    if (!forwarding_) return;
    if (auto next = forwarding_->pass_on(config, std::move(sample)))
      hand_to(directory_.at(next->hop), std::move(next->sample), now);
    return;
  }
  MissionTime& latest = latest_heard_[NodeNumber(header.origin)];
  latest = std::max(latest, MissionTime::nanoseconds(header.mission_time));
  if (world) return admit_published(origin, std::move(sample), now);
  admit_from_peer(channel, *origin, std::move(sample), now);
}

void Blackboard::Impl::admit_from_peer(std::size_t channel, Peer& peer, wire::Sample&& sample,
                                       Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const wire::SampleHeader header = wire::header_of(sample);
  if (const auto* heartbeat = std::get_if<wire::Heartbeat>(&sample))
    return admit_heartbeat(channel, peer, *heartbeat, now);
  if (header.incarnation < peer.incarnation() && !peer.known().lives.is_former(header.incarnation))
    return peer.known().lives.has_older_rival()
               ? drops_.tell(wire::Slot::kHeartbeat, header, kOfOlderSecond, out_)
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
  const Novelty novelty = peer.session().lives.note(heartbeat);
  if (novelty == Novelty::kReplayed)
    return note_replay(channel, wire::Slot::kHeartbeat, heartbeat.header);
  if (novelty == Novelty::kKnown) return;
  if (forwarding_ && heartbeat.header.via.empty() && over.kind == ChannelKind::kRadio)
    forwarding_->on_heartbeat(over.from, now.steady);
  const std::uint64_t before = peer.incarnation();
  const bool was_refused = peer.known().lives.was_refused(heartbeat.header.incarnation);
  const bool was_reachable = peer.reachable();
  peer.on_heartbeat(heartbeat, now, out_);
  const bool is_first_again = peer.incarnation() < before;
  if (is_first_again) {  // of two processes with its number, the second of which may be gone
    if (was_reachable) drops_.tell(wire::Slot::kHeartbeat, heartbeat.header, kOfSecond, out_);
    freshness_.return_to(heartbeat.header.origin, peer.incarnation());
    if (forwarding_) forwarding_->forget(peer.channels().number);
  }
  if ((is_first_again || was_refused) && peer.line().incoming().up)
    connections_.set_up_anew(peer.channels().incoming, now.steady, out_);
  hear(peer);
}

/// A malformed event still has its place in the sequence: what follows it must not wait.
void Blackboard::Impl::refuse_event(std::size_t channel, wire::Slot slot,
                                    const wire::SampleHeader& header, Now now) {
  if (!is_event(slot) || header_violation(header)) return;
  Peer* from = directory_.over(channel);
  if (from == nullptr || header.origin != from->channels().number.value()) return;
  if (!header.via.empty()) return;
  if (header.destination != config_.self.value()) return;
  from->on_event(header, std::nullopt, now, out_);
  hear(*from);
}

void Blackboard::Impl::show_life(std::size_t channel, const wire::SampleHeader& header, Now now) {
  const ChannelConfig& over = config_.channels[channel];
  if (over.from.value() != header.origin || !header.via.empty() ||
      directory_.over(channel) == nullptr)
    return;
  directory_.over(channel)->on_sign_of_life(header.incarnation, now.steady);
  if (forwarding_ && over.kind == ChannelKind::kRadio)
    forwarding_->on_sign_of_life(over.from, now.steady);
}

void Blackboard::Impl::hear(Peer& peer) {
  if (heard_.empty() || heard_.back() != &peer) heard_.push_back(&peer);
  directory_.plan(peer);
}

}  // namespace skein::blackboard
