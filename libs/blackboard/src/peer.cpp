// SPDX-License-Identifier: Apache-2.0
// Reachability of one peer and the event session with it.
#include "peer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace skein::blackboard {
namespace {

void acknowledge(const IncomingParts& incoming, wire::Part& by) {
  by.ack_incarnation = incoming.ack_incarnation();
  by.ack_number = incoming.ack_number();
  by.ack_bytes = incoming.ack_bytes();
  by.ack_lacks = incoming.ack_lacks();
}

/// Whether no later sample takes the place of one in this slot.
bool counts_each(wire::Slot slot) {
  return slot == wire::Slot::kHeartbeat || slot == wire::Slot::kPart ||
         wire::slot_class(slot) == wire::SlotClass::kEvent;
}

std::optional<Duration> sooner(std::optional<Duration> a, std::optional<Duration> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

}  // namespace

Peer::Peer(PeerChannels channels, const Config& config, const Session& none)
    : config_(&config),
      none_(&none),
      line_(channels, config),
      heartbeats_(config.heartbeat_period) {}

Session& Peer::session() {
  if (!session_) session_ = std::make_unique<Session>(*config_);
  return *session_;
}

void Peer::set_outgoing(const ChannelCondition& condition, Now now) {
  if (condition.up && !line_.outgoing().up) heartbeats_.at_once(now.steady);
  line_.set_outgoing(condition, now.steady);
}

// The transport gives its history again whenever the channel is up again, long silence or not.
void Peer::set_incoming(const ChannelCondition& condition) {
  if (session_ && condition.up && !line_.incoming().up)
    session_->lives.present().incoming.begin_contact();
  line_.set_incoming(condition);
}

void Peer::set_way(std::size_t relays, bool heard_of, bool anew, Now now) {
  line_.set_way(relays, heard_of);
  if (!anew) return;
  heartbeats_.at_once(now.steady);
  if (session_) session_->resend();
}

void Peer::deliver(Now now, std::vector<Incoming>& out) {
  IncomingEvents& incoming = session().lives.present().incoming;
  incoming.deliver(channels().kind, now.mission, out);
  if (incoming.owes_acknowledgement())
    heartbeats_.owe(now.steady + line_.round_trip().acknowledgement_delay());
}

Novelty Peer::on_event(const wire::SampleHeader& header, std::optional<wire::Sample> event, Now now,
                       std::vector<Incoming>& out) {
  Lives& lives = session().lives;
  Life* life = lives.with(header.incarnation, reachable_, now.steady);
  if (life == nullptr || is_refused_) return Novelty::kKnown;
  const Novelty novelty = life->incoming.on_event(header, std::move(event));
  if (life != &lives.present()) return novelty;
  deliver(now, out);
  return novelty;
}

void Peer::on_heartbeat(const wire::Heartbeat& heartbeat, Now now, std::vector<Incoming>& out) {
  const std::uint64_t incarnation = heartbeat.header.incarnation;
  Lives& lives = session().lives;
  const bool is_former_again =
      lives.is_former(incarnation) && lives.former_goes_on(line_.silence_limit(), now.steady);
  if (incarnation < lives.present().incarnation) return;
  lives.forget_silent_rival(line_.silence_limit(), now.steady);
  const bool is_another = incarnation > lives.present().incarnation;
  const bool restarted = (is_another && lives.present().incarnation != 0) || is_former_again;
  if (is_another) {
    lives.follow(incarnation, reachable_, now.steady);
    lives.present().newest_heartbeat = heartbeat.header.sequence_number;
  }
  lives.heard_present(restarted);
  const bool was_heard = is_heard_;
  take_acknowledgement(heartbeat, out);
  // It may never have been silent here, and would wait for the heartbeat of the period.
  if (was_heard && !is_heard_) heartbeats_.at_once(now.steady);
  if (!reachable_ || restarted) {
    out.emplace_back(Reachability{channels().number, true, restarted});
    session().resend();
    if (restarted) session().long_states.begin_again();
    heartbeats_.at_once(now.steady);
    lives.present().incoming.begin_contact();
  }
  reachable_ = true;
  session().set_contact(true);
  recalled_ = false;
  lives.present().last_heard = now.steady;
  lives.present().incoming.on_heartbeat(heartbeat, out);
  deliver(now, out);
}

void Peer::take_acknowledgement(const wire::Heartbeat& heartbeat, std::vector<Incoming>& out) {
  const std::uint64_t heard = heartbeat.ack_incarnation;
  const bool is_heard = heard == self_incarnation();
  if (is_heard) {
    for (const std::uint64_t receipt : session().outgoing.acknowledge(heartbeat.ack_sequence)) {
      out.emplace_back(EventDelivered{channels().number, receipt});
    }
  }
  if (is_heard && !is_heard_ && was_heard_) session().outgoing.resend();
  is_heard_ = is_heard;
  was_heard_ = was_heard_ || is_heard;
  const bool is_refused = was_heard_ && heard != 0 && heard < self_incarnation();
  if (is_refused && !is_refused_) out.emplace_back(TakenForOlder{channels().number, heard, false});
  is_refused_ = is_refused;
}

void Peer::on_old_heartbeat(std::uint64_t incarnation, Duration now) {
  heard_old_ = true;
  Lives& lives = session().lives;
  lives.heard_older();
  if (!reachable_) lives.consider_older(incarnation, line_.silence_limit(), now);
}

void Peer::become(std::uint64_t incarnation, Duration now) {
  session().become(config_->self, incarnation);
  heartbeats_.at_once(now);
}

void Peer::recall_sent(wire::Sample event, std::uint64_t receipt) {
  session().recall_sent(std::move(event), receipt);
  recalled_ = true;
}

void Peer::recall_reachable(bool reachable) {
  reachable_ = reachable;
  session().set_contact(reachable);
  recalled_ = true;
}

// The silence of a peer that was in reach is counted from the first update of this life.
void Peer::update(Now now, std::vector<Incoming>& out) {
  if (!session_) return;
  Life& life = session_->lives.present();
  if (recalled_ && life.last_heard == Duration{}) life.last_heard = now.steady;
  if (reachable_ && now.steady - life.last_heard >= line_.silence_limit()) {
    reachable_ = false;
    session_->set_contact(false);
    out.emplace_back(Reachability{channels().number, false, false});
  }
  if (recalled_) return;  // what it has acknowledged is not known before it is heard
  for (const EventExpired& expired : session_->expire(now.mission)) out.emplace_back(expired);
}

std::vector<const wire::Sample*> Peer::take_due_events(Now now) {
  if (!line_.can_send() || recalled_ || !session_) return {};
  return session_->outgoing.take_due(now, line_.round_trip().of_event());
}

bool Peer::heartbeat_due(Duration steady) const {
  return line_.can_send() && heartbeats_.due(steady);
}

wire::Heartbeat Peer::take_heartbeat(Duration steady) {
  heartbeats_.sent(steady);
  if (session_) session_->lives.present().incoming.acknowledged();
  const auto& [outgoing, parts_out, long_states, lives] = known();
  wire::Heartbeat heartbeat;
  heartbeat.events_from = outgoing.oldest();
  heartbeat.events_to = outgoing.next_sequence() - 1;
  heartbeat.ack_incarnation = reachable_ || heard_old_ ? lives.present().incarnation : 0;
  heard_old_ = false;
  heartbeat.ack_sequence = reachable_ ? lives.present().incoming.ack_sequence() : 0;
  return heartbeat;
}

void Peer::put(wire::Sample sample) {
  LimitedChannel& limited = *line_.limited();
  if (counts_each(wire::slot_of(sample))) return limited.pass(std::move(sample));
  if (line_.is_long_state(sample)) {
    limited.drop(sample);
    if (session().long_states.put(std::move(sample))) limited.shed_one();
    return;
  }
  if (session_ && session_->long_states.drop(sample)) limited.shed_one();
  limited.put(std::move(sample));
}

void Peer::pass_by(const wire::Sample& state) {
  if (session_) session_->long_states.drop(state);
}

std::vector<wire::Sample> Peer::let_go() {
  std::vector<wire::Sample> states;
  if (session_) states = session_->long_states.let_go();
  if (LimitedChannel* limited = line_.limited()) {
    std::ranges::move(limited->let_go(), std::back_inserter(states));
  }
  return states;
}

std::optional<std::variant<wire::Sample, Malformed>> Peer::on_part(const wire::Part& part, Now now,
                                                                   std::vector<Incoming>& out) {
  Life& life = session().lives.present();
  if (is_refused_ || (reachable_ && part.header.incarnation != life.incarnation))
    return std::nullopt;
  if (part.ack_incarnation == self_incarnation()) {
    for (const std::uint64_t receipt :
         session().parts_out.heard(part.ack_number, part.ack_bytes, part.ack_lacks))
      out.emplace_back(EventDelivered{channels().number, receipt});
    if (part.ack_number < kFirstLongEvent)
      session().long_states.heard(part.ack_number, part.ack_bytes, part.ack_lacks);
  }
  if (part.number == 0) return std::nullopt;
  const bool of_event = part.number >= kFirstLongEvent;
  IncomingParts& incoming = of_event ? life.parts : life.state_parts;
  auto sample = incoming.take(part);
  if (!of_event) incoming.commit();
  if (incoming.owes() && !acknowledge_parts_at_)
    acknowledge_parts_at_ =
        now.steady + (of_event ? line_.round_trip().acknowledgement_delay() : RoundTrip::kAtOnce);
  return sample;
}

std::optional<wire::Part> Peer::due_part(Now now) const {
  std::optional<wire::Part> part;
  if (sends_parts())
    part = known().parts_out.next(now.steady, line_.bytes_of_a_part(),
                                  config_->retransmission + line_.round_trip().of_event());
  const bool owes =
      line_.can_send() && acknowledge_parts_at_ && now.steady >= *acknowledge_parts_at_;
  if (!part && !owes) return std::nullopt;
  if (!part) part.emplace();
  const Life& life = known().lives.present();
  acknowledge(!part->content.empty() || life.parts.owes() ? life.parts : life.state_parts, *part);
  return part;
}

void Peer::part_written(const wire::Part& part, Duration until) {
  Life& life = session().lives.present();
  const bool tells_of_states = part.ack_number != 0 && part.ack_number < kFirstLongEvent;
  (tells_of_states ? life.state_parts : life.parts).told();
  if (!life.parts.owes() && !life.state_parts.owes()) acknowledge_parts_at_.reset();
  if (part.number >= kFirstLongEvent) session().parts_out.written(part, until);
}

wire::Part Peer::take_state_part(wire::Slot slot, Now now, Duration until) {
  wire::Part part = session_->long_states.take(slot, line_.bytes_of_a_part(), now.steady,
                                               line_.round_trip().of_state_part(), until);
  acknowledge(session_->lives.present().state_parts, part);
  part_written(part, until);
  return part;
}

std::optional<wire::Part> Peer::take_part(Now now) {
  auto part = due_part(now);
  if (part) part_written(*part, now.steady);
  return part;
}

std::optional<wire::Sample> Peer::take_next(Now now) {
  LimitedChannel* const limited = line_.limited();
  if (limited == nullptr || !line_.outgoing().up || now.steady < limited->free_at())
    return std::nullopt;
  const bool has_own = !recalled_ && !line_.is_relayed();
  const wire::Sample* own =
      has_own ? known().outgoing.first_due(now, line_.round_trip().of_event()) : nullptr;
  const wire::Sample* passing = limited->first_passing(now.mission);
  const bool passes = passing != nullptr && (own == nullptr || turn_of_passing_);
  const wire::Sample* event = passes ? passing : own;
  std::optional<wire::Sample> part;
  if (!line_.is_relayed()) part = due_part(now);
  LimitedChannel::Waiting first;
  if (sends_state_parts())
    first.long_states = session_->long_states.due(now.steady, line_.bytes_of_a_part(),
                                                  line_.round_trip().of_state_part());
  if (heartbeat_due(now.steady)) first.heartbeat = heartbeat_bytes();
  if (event != nullptr) first.event = channel_bytes(*event);
  if (part) first.part = channel_bytes(*part);
  const auto turn = limited->next(first, now.steady);
  if (!turn) return std::nullopt;
  const Duration until = limited->write(*turn, now.steady);
  if (turn->of == LimitedChannel::Turn::Of::kPart) {
    part_written(std::get<wire::Part>(*part), until);
    return part;
  }
  if (turn->of == LimitedChannel::Turn::Of::kHeartbeat) return take_heartbeat(now.steady);
  if (turn->of == LimitedChannel::Turn::Of::kValue) return limited->take(*turn);
  if (turn->of == LimitedChannel::Turn::Of::kLongState)
    return take_state_part(turn->slot, now, until);
  turn_of_passing_ = !passes;
  if (passes) return limited->take_passing();
  wire::Sample written = *event;
  session().outgoing.written(written, until);
  return written;
}

std::optional<Duration> Peer::next_wakeup() const {
  std::optional<Duration> silent;
  if (reachable_) silent = known().lives.present().last_heard + line_.silence_limit();
  if (!line_.can_send()) return silent;
  std::optional<Duration> write = heartbeats_.next();
  if (!recalled_) write = sooner(write, known().outgoing.next_due(line_.round_trip().of_event()));
  write = sooner(write, acknowledge_parts_at_);
  if (sends_parts())
    write = sooner(
        write, known().parts_out.next_due(line_.bytes_of_a_part(),
                                          config_->retransmission + line_.round_trip().of_event()));
  if (sends_state_parts())
    write = sooner(write, session_->long_states.next_due(line_.bytes_of_a_part(),
                                                         line_.round_trip().of_state_part()));
  const LimitedChannel* limited = line_.limited();
  if (limited != nullptr && line_.outgoing().up) {
    if (limited->has_any()) write = limited->free_at();
    write = std::max(*write, limited->free_at());
  }
  return sooner(silent, write);
}

}  // namespace skein::blackboard
