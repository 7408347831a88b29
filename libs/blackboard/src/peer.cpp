// SPDX-License-Identifier: Apache-2.0
// Reachability of one peer and the event session with it.
#include "peer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace skein::blackboard {
namespace {

/// A little less than the period: after three of them a peer counts as lost, and the third
/// heartbeat, on its way a little longer than those before it, has to be there by then. Else two
/// that are lost in a row, 1 in 11 at 30 % loss, are a cut.
Duration between_heartbeats(Duration period) {
  return Duration::nanoseconds(period.count() * 19 / 20);
}

/// An event of more goes in parts [byte]; less is what would keep a narrow channel from heartbeats,
/// but not less than this.
constexpr double kLongEvent = 16'384, kLeastLongEvent = 1024;
/// Content of a part [byte], as long as the wire allows and no longer than others may wait for it.
constexpr double kLongestPart = 4096, kShortestPart = 512;
constexpr double kPartsASecond = 4;
/// A state of more goes in parts, on a channel of limited capacity.
constexpr std::size_t kPartsOfALongState = 2;
constexpr double kBitsPerByte = 8;

void acknowledge(const IncomingParts& incoming, wire::Part& by) {
  by.ack_incarnation = incoming.ack_incarnation();
  by.ack_number = incoming.ack_number();
  by.ack_bytes = incoming.ack_bytes();
  by.ack_lacks = incoming.ack_lacks();
}

std::optional<Duration> sooner(std::optional<Duration> a, std::optional<Duration> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

}  // namespace

Peer::Peer(PeerChannels channels, const Config& config, const Session& none)
    : channels_(channels), config_(&config), none_(&none), period_(config.heartbeat_period) {
  limit(config.channels[channels.outgoing].capacity, {});
}

Peer::Session& Peer::session() {
  if (!session_) session_ = std::make_unique<Session>(*config_);
  return *session_;
}

void Peer::limit(double capacity, Duration now) {
  if (capacity <= 0) return limited_.reset();
  if (!limited_)
    limited_ = std::make_unique<LimitedChannel>(config_->channels[channels_.outgoing].slots,
                                                config_->shares, period_);
  limited_->set_capacity(capacity, now);
}

void Peer::set_outgoing(const ChannelCondition& condition, Now now) {
  if (condition.up && !out_condition_.up) next_heartbeat_ = now.steady;
  out_condition_ = condition;
  const double declared = config_->channels[channels_.outgoing].capacity;
  const double capacity = condition.capacity > 0 ? condition.capacity : declared;
  if (condition.up || capacity > 0) limit(capacity, now.steady);
  if (limited_ && !condition.up) limited_->cut();
}

RoundTrip Peer::round_trip() const {
  RoundTrip trip;
  trip.latency = out_condition_.latency + in_condition_.latency;
  trip.out = limited_ ? limited_->capacity() : 0;
  trip.back = in_condition_.capacity > 0 ? in_condition_.capacity
                                         : config_->channels[channels_.incoming].capacity;
  trip.relays = relays_;
  trip.period = period_;
  return trip;
}

void Peer::owe_acknowledgement(Duration now) {
  if (!session().lives.present().incoming.owes_acknowledgement() || acknowledge_at_) return;
  acknowledge_at_ = now + round_trip().acknowledgement_delay();
}

void Peer::set_way(std::size_t relays, bool heard_of, bool anew, Now now) {
  relays_ = relays;
  heard_of_ = heard_of;
  if (!anew) return;
  next_heartbeat_ = now.steady;
  if (!session_) return;
  session_->outgoing.resend();
  session_->parts_out.resend();
  session_->long_states.resend();
}

// Who is heard by somebody is only waited for while the way past that one opens.
Duration Peer::silence_limit() const {
  const Duration limit = period_ + period_ + period_;
  return heard_of_ ? limit + limit : limit;
}

Novelty Peer::on_event(const wire::SampleHeader& header, std::optional<wire::Sample> event, Now now,
                       std::vector<Incoming>& out) {
  Lives& lives = session().lives;
  Life* life = lives.with(header.incarnation, reachable_, now.steady);
  if (life == nullptr || is_refused_) return Novelty::kKnown;
  const Novelty novelty = life->incoming.on_event(header, std::move(event));
  if (life != &lives.present()) return novelty;
  lives.present().incoming.deliver(channels_.kind, now.mission, out);
  owe_acknowledgement(now.steady);
  return novelty;
}

void Peer::on_heartbeat(const wire::Heartbeat& heartbeat, Now now, std::vector<Incoming>& out) {
  const std::uint64_t incarnation = heartbeat.header.incarnation;
  auto& [outgoing, parts_out, long_states, lives] = session();
  const bool is_former_again =
      lives.is_former(incarnation) && lives.former_goes_on(silence_limit(), now.steady);
  if (incarnation < lives.present().incarnation) return;
  lives.forget_silent_rival(silence_limit(), now.steady);
  const bool is_another = incarnation > lives.present().incarnation;
  const bool restarted = (is_another && lives.present().incarnation != 0) || is_former_again;
  if (is_another) {
    lives.follow(incarnation, reachable_, now.steady);
    lives.present().newest_heartbeat = heartbeat.header.sequence_number;
  }
  if (restarted) rival_turns_ = 0;
  heard_latest_ = true;
  take_acknowledgement(heartbeat, out);
  if (!reachable_ || restarted) {
    out.emplace_back(Reachability{channels_.number, true, restarted});
    outgoing.resend();
    parts_out.resend();
    long_states.resend();
    if (restarted) long_states.begin_again();
    next_heartbeat_ = now.steady;
    lives.present().incoming.begin_contact();
  }
  reachable_ = true;
  outgoing.set_contact(true);
  parts_out.set_contact(true);
  recalled_ = false;
  lives.present().last_heard = now.steady;
  lives.present().incoming.on_heartbeat(heartbeat, out);
  lives.present().incoming.deliver(channels_.kind, now.mission, out);
  owe_acknowledgement(now.steady);
}

void Peer::take_acknowledgement(const wire::Heartbeat& heartbeat, std::vector<Incoming>& out) {
  const std::uint64_t heard = heartbeat.ack_incarnation;
  const bool is_heard = heard == self_incarnation();
  if (is_heard) {
    for (const std::uint64_t receipt : session().outgoing.acknowledge(heartbeat.ack_sequence)) {
      out.emplace_back(EventDelivered{channels_.number, receipt});
    }
  }
  if (is_heard && !is_heard_ && was_heard_) session().outgoing.resend();
  is_heard_ = is_heard;
  was_heard_ = was_heard_ || is_heard;
  const bool is_refused = was_heard_ && heard != 0 && heard < self_incarnation();
  if (is_refused && !is_refused_) out.emplace_back(TakenForOlder{channels_.number, heard, false});
  is_refused_ = is_refused;
}

void Peer::on_old_heartbeat() {
  heard_old_ = true;
  if (std::exchange(heard_latest_, false)) ++rival_turns_;
}

void Peer::become(std::uint64_t incarnation, Duration now) {
  session().outgoing.become(incarnation);
  session().parts_out.become(incarnation);
  session().long_states.drop_from(config_->self.value());
  session().lives.become(incarnation);
  next_heartbeat_ = now;
}

void Peer::recall_sent(wire::Sample event, std::uint64_t receipt) {
  if (wire::header_of(event).sequence_number >= kFirstLongEvent) {
    session().parts_out.hold(event, receipt);
  } else {
    session().outgoing.recall(std::move(event), receipt);
  }
  recalled_ = true;
}

void Peer::recall_acknowledged(std::uint64_t number) {
  if (number >= kFirstLongEvent) return session().parts_out.recall_acknowledged(number);
  session().outgoing.acknowledge(number);
}

void Peer::recall_given_up(std::uint64_t number) {
  if (number >= kFirstLongEvent) return session().parts_out.give_up(number);
  session().outgoing.give_up(number);
}

bool Peer::has_room_for(const wire::Sample& event) const {
  return is_long(event) ? !known().parts_out.full() : !known().outgoing.full();
}

std::uint64_t Peer::next_number(const wire::Sample& event) const {
  return is_long(event) ? known().parts_out.next_number() : known().outgoing.next_sequence();
}

void Peer::hold(wire::Sample event, std::uint64_t receipt) {
  if (wire::header_of(event).sequence_number >= kFirstLongEvent)
    return session().parts_out.hold(event, receipt);
  session().outgoing.hold(std::move(event), receipt);
}

void Peer::recall_received(const wire::SampleHeader& header) {
  Life& life = session().lives.present();
  life.incarnation = std::max(life.incarnation, header.incarnation);
  if (header.sequence_number >= kFirstLongEvent)
    return life.parts.recall(header.incarnation, header.sequence_number);
  life.incoming.recall(header);
}

void Peer::recall_reachable(bool reachable) {
  reachable_ = reachable;
  session().outgoing.set_contact(reachable);
  session().parts_out.set_contact(reachable);
  recalled_ = true;
}

// The silence of a peer that was in reach is counted from the first update of this life.
void Peer::update(Now now, std::vector<Incoming>& out) {
  if (!session_) return;
  auto& [outgoing, parts_out, long_states, lives] = *session_;
  Life& life = lives.present();
  if (recalled_ && life.last_heard == Duration{}) life.last_heard = now.steady;
  if (reachable_ && now.steady - life.last_heard >= silence_limit()) {
    reachable_ = false;
    outgoing.set_contact(false);
    parts_out.set_contact(false);
    out.emplace_back(Reachability{channels_.number, false, false});
  }
  if (recalled_) return;  // what it has acknowledged is not known before it is heard
  for (const EventExpired& expired : outgoing.expire(now.mission)) out.emplace_back(expired);
  for (const EventExpired& expired : parts_out.expire(now.mission)) out.emplace_back(expired);
}

std::vector<const wire::Sample*> Peer::take_due_events(Now now) {
  if (!can_send() || recalled_ || !session_) return {};
  return session_->outgoing.take_due(now, round_trip().of_event());
}

bool Peer::heartbeat_due(Duration steady) const {
  if (!can_send()) return false;
  return steady >= next_heartbeat_ || (acknowledge_at_ && steady >= *acknowledge_at_);
}

wire::Heartbeat Peer::take_heartbeat(Duration steady) {
  next_heartbeat_ = steady + between_heartbeats(period_);
  acknowledge_at_.reset();
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

bool Peer::is_long(const wire::Sample& event) const {
  const ChannelConfig& channel = config_->channels[channels_.outgoing];
  if (!channel.carries(wire::Slot::kPart)) return false;
  double most = kLongEvent;
  if (channel.capacity > 0) {
    const double in_two_periods = channel.capacity / kBitsPerByte * 2 * period_.to_seconds();
    most = std::clamp(in_two_periods, kLeastLongEvent, kLongEvent);
  }
  return static_cast<double>(channel_bytes(event)) > most;
}

std::uint32_t Peer::bytes_of_a_part() const {
  if (!limited_) return static_cast<std::uint32_t>(kLongestPart);
  return static_cast<std::uint32_t>(
      std::clamp(limited_->capacity() / kBitsPerByte / kPartsASecond, kShortestPart, kLongestPart));
}

void Peer::put(wire::Sample value) {
  const bool is_long_state = wire::slot_class(wire::slot_of(value)) == wire::SlotClass::kState &&
                             config_->channels[channels_.outgoing].carries(wire::Slot::kPart) &&
                             channel_bytes(value) > kPartsOfALongState * bytes_of_a_part();
  if (is_long_state) {
    limited_->drop(value);
    if (session().long_states.put(std::move(value))) limited_->shed_one();
    return;
  }
  if (session_ && session_->long_states.drop(value)) limited_->shed_one();
  limited_->put(std::move(value));
}

void Peer::pass_by(const wire::Sample& state) {
  if (session_) session_->long_states.drop(state);
}

std::vector<wire::Sample> Peer::let_go() {
  std::vector<wire::Sample> states;
  if (session_) states = session_->long_states.let_go();
  if (limited_) std::ranges::move(limited_->let_go(), std::back_inserter(states));
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
      out.emplace_back(EventDelivered{channels_.number, receipt});
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
        now.steady + (of_event ? round_trip().acknowledgement_delay() : RoundTrip::kAtOnce);
  return sample;
}

std::optional<wire::Part> Peer::due_part(Now now) const {
  std::optional<wire::Part> part;
  if (sends_parts())
    part = known().parts_out.next(now.steady, bytes_of_a_part(),
                                  config_->retransmission + round_trip().of_event());
  const bool owes = can_send() && acknowledge_parts_at_ && now.steady >= *acknowledge_parts_at_;
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
  wire::Part part = session_->long_states.take(slot, bytes_of_a_part(), now.steady,
                                               round_trip().of_state_part(), until);
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
  if (!limited_ || !out_condition_.up || now.steady < limited_->free_at()) return std::nullopt;
  const bool has_own = !recalled_ && relays_ == 0;
  const wire::Sample* own =
      has_own ? known().outgoing.first_due(now, round_trip().of_event()) : nullptr;
  const wire::Sample* passing = limited_->first_passing(now.mission);
  const bool passes = passing != nullptr && (own == nullptr || turn_of_passing_);
  const wire::Sample* event = passes ? passing : own;
  std::optional<wire::Sample> part;
  if (relays_ == 0) part = due_part(now);
  LimitedChannel::Waiting first;
  if (sends_state_parts())
    first.long_states =
        session_->long_states.due(now.steady, bytes_of_a_part(), round_trip().of_state_part());
  if (heartbeat_due(now.steady)) first.heartbeat = heartbeat_bytes();
  if (event != nullptr) first.event = channel_bytes(*event);
  if (part) first.part = channel_bytes(*part);
  const auto turn = limited_->next(first, now.steady);
  if (!turn) return std::nullopt;
  const Duration until = limited_->write(*turn, now.steady);
  if (turn->of == LimitedChannel::Turn::Of::kPart) {
    part_written(std::get<wire::Part>(*part), until);
    return part;
  }
  if (turn->of == LimitedChannel::Turn::Of::kHeartbeat) return take_heartbeat(now.steady);
  if (turn->of == LimitedChannel::Turn::Of::kValue) return limited_->take(*turn);
  if (turn->of == LimitedChannel::Turn::Of::kLongState)
    return take_state_part(turn->slot, now, until);
  turn_of_passing_ = !passes;
  if (passes) return limited_->take_passing();
  wire::Sample written = *event;
  session().outgoing.written(written, until);
  return written;
}

std::optional<Duration> Peer::next_wakeup() const {
  std::optional<Duration> silent;
  if (reachable_) silent = known().lives.present().last_heard + silence_limit();
  if (!can_send()) return silent;
  auto write = sooner(next_heartbeat_, acknowledge_at_);
  if (!recalled_) write = sooner(write, known().outgoing.next_due(round_trip().of_event()));
  write = sooner(write, acknowledge_parts_at_);
  if (sends_parts())
    write =
        sooner(write, known().parts_out.next_due(
                          bytes_of_a_part(), config_->retransmission + round_trip().of_event()));
  if (sends_state_parts())
    write = sooner(write,
                   session_->long_states.next_due(bytes_of_a_part(), round_trip().of_state_part()));
  if (limited_ && out_condition_.up) {
    if (limited_->has_any()) write = limited_->free_at();
    write = std::max(*write, limited_->free_at());
  }
  return sooner(silent, write);
}

}  // namespace skein::blackboard
