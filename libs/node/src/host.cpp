// SPDX-License-Identifier: Apache-2.0
#include "skein/node/host.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "recollection.hpp"
#include "skein/blackboard/link_instance.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"

namespace skein::node {

namespace lines = journal::lines;

namespace {

using blackboard::ChannelKind;
using blackboard::Now;

bool is_radio_peer(const Roster& roster, NodeNumber number) {
  const Member* member = roster.find(number);
  return member != nullptr &&
         (member->role == wire::Role::kGround || member->role == wire::Role::kDdn);
}

LoggedInput logged(const Input& input) {
  return std::visit(Overloaded{[](const JobDone& done) {
                                 return LoggedInput(JobEnded{done.id, done.clock});
                               },
                               [](const auto& one) { return LoggedInput(one); }},
                    input);
}

Skipped skipped(wire::Slot slot, NodeNumber from, std::uint64_t incarnation,
                std::uint64_t sequence) {
  Skipped event{slot, {}};
  event.header.origin = from.value();
  event.header.incarnation = incarnation;
  event.header.sequence_number = sequence;
  return event;
}

/// Whoever leads the clock writes it, whatever its role.
void add_clock(std::vector<blackboard::ChannelConfig>& channels) {
  for (blackboard::ChannelConfig& channel : channels) {
    if (channel.kind != ChannelKind::kWorld) continue;
    if (std::ranges::find(channel.slots, wire::Slot::kClock) == channel.slots.end()) {
      channel.slots.push_back(wire::Slot::kClock);
    }
  }
}

/// So that what a node sends does not ask too much of its radio before, and where, nobody says what
/// that can carry.
std::vector<blackboard::ChannelConfig> with_capacities(
    std::vector<blackboard::ChannelConfig> channels, const Roster& roster,
    const HostConfig& config) {
  for (blackboard::ChannelConfig& channel : channels) {
    if (channel.kind != ChannelKind::kRadio) continue;
    channel.capacity = config.share_of_samples * config.rate *
                       config.capacity.of(roster.name_of(channel.from), roster.name_of(channel.to));
  }
  return channels;
}

/// All channels at once, or those with other UAVs when they are needed. Relays hear of nodes that
/// were never in their own reach.
void plan_channels(blackboard::Config& board, const Roster& roster, const Member& self,
                   const HostConfig& config) {
  const bool waits =
      config.meets_when_told && roster.relays().empty() && self.role == wire::Role::kDdn;
  board.channels = with_capacities(
      waits ? roster.channels_but_between_uavs(self) : roster.channels_of(self), roster, config);
  if (!waits) return;
  board.channels_with = [roster, self, config](NodeNumber other) {
    const Member* member = roster.find(other);
    if (member == nullptr || member->role != wire::Role::kDdn)
      return std::vector<blackboard::ChannelConfig>();
    return with_capacities(roster.channels_between(self, *member), roster, config);
  };
}

bool is_world(const blackboard::ChannelConfig& channel) {
  return channel.kind == ChannelKind::kWorld;
}

/// Of what comes over the world channel; the rest is the runtime's.
bool is_for_nodes(wire::Slot slot) {
  using wire::Slot;
  return slot == Slot::kTruth || slot == Slot::kOperatorRequest || slot == Slot::kOperatorReply ||
         slot == Slot::kUavBoard || slot == Slot::kUavTasks || slot == Slot::kGroundBoard;
}

bool is_of_the_world(const blackboard::Incoming& incoming) {
  const auto* received = std::get_if<blackboard::Received>(&incoming);
  return received != nullptr && received->channel == ChannelKind::kWorld;
}

}  // namespace

Result<std::unique_ptr<Host>, OpenFailure> Host::open(const Roster& roster, const Member& self,
                                                      std::unique_ptr<Node> node,
                                                      blackboard::Transport& transport,
                                                      const HostConfig& config, HostPorts ports) {
  blackboard::Config board;
  board.self = self.number;
  board.incarnation = config.incarnation;
  plan_channels(board, roster, self, config);
  if (config.leads_clock) add_clock(board.channels);
  if (config.world) {
    board.world_reads = roster.world_reads_of(self.role);
  } else {
    std::erase_if(board.channels, is_world);
  }
  board.shares = roster.slots().shares();
  board.lifespans = roster.slots().lifespans();
  board.heartbeat_period = config.heartbeat_period;
  board.retransmission =
      Duration::nanoseconds(config.heartbeat_period.count() + config.heartbeat_period.count() / 2);
  board.seed = config.seed;
  board.relaying.relays = roster.relays();
  Survey past;
  if (config.memory != nullptr) {
    auto found = survey(*config.memory);
    if (!found) return tl::unexpected(OpenFailure{found.error().why, true});
    past = std::move(*found);
  }
  if (config.forgets) {
    board.incarnation = std::max(config.incarnation, past.incarnation + 1);
  } else if (past.lives > 0) {
    board.life = past.lives;
    board.incarnation = past.incarnation;
  }
  board.guesses_incarnation = config.guesses_incarnation && config.memory == nullptr;
  const std::uint64_t board_incarnation = board.incarnation;
  auto opened = blackboard::Blackboard::open(std::move(board), transport);
  if (!opened) return tl::unexpected(OpenFailure{opened.error().why});
  std::unique_ptr<Host> host(
      new Host(roster, self, std::move(node), std::move(*opened), config, std::move(ports)));
  host->config_.incarnation = board_incarnation;
  if (past.lives > 0) {
    auto recalled = config.forgets ? host->recall_the_world() : host->recall(std::move(past));
    if (!recalled) return tl::unexpected(OpenFailure{recalled.error().why, true});
  }
  return host;
}

Host::Host(const Roster& roster, const Member& self, std::unique_ptr<Node> node,
           blackboard::Blackboard blackboard, const HostConfig& config, HostPorts ports)
    : roster_(roster),
      self_(self),
      node_(std::move(node)),
      blackboard_(std::move(blackboard)),
      config_(config),
      ports_(std::move(ports)),
      node_due_(node_->next_wakeup()) {}

void Host::start(Now now, bool first_life) {
  SKEIN_EXPECTS(!started_);
  started_ = true;
  if (!resumed_from_ || config_.forgets) {
    carry_out(std::exchange(left_, {}), now);
    give(Started{config_.incarnation, first_life && !resumed_from_}, now);
  } else {
    log(lines::Resumed{resumed_from_->to_seconds()}, now);
    const std::uint64_t sends = sends_;  // states that are sent again are none of the node's
    gives_out_again_ = true;
    carry_out(std::exchange(left_, {}), now);
    gives_out_again_ = false;
    sends_ = sends;
    give(Restarted{}, now);
  }
  for (auto& incoming : std::exchange(before_start_, {})) take(std::move(incoming), now);
}

bool Host::step(Now now) {
  std::vector<blackboard::Incoming> incoming = blackboard_.receive(now, started_);
  apply_links(incoming, now);
  std::ranges::move(blackboard_.act(now), std::back_inserter(incoming));
  bool busy = !incoming.empty();
  note_settled(now);
  for (auto& one : incoming) take(std::move(one), now);
  if (started_ && node_due_ && *node_due_ <= now.mission) {
    give(Wakeup{}, now);
    busy = true;
  }
  return busy;
}

void Host::listen(Now now) {
  std::vector<blackboard::Incoming> incoming = blackboard_.receive(now, started_);
  apply_links(incoming, now);
  for (auto& one : incoming) take(std::move(one), now);
}

Result<void, Failure> Host::recall(Survey past) {
  Recollection recollection(*node_, &blackboard_, std::move(past));
  if (auto recalled = recollection.run(*config_.memory); !recalled) return recalled;
  resumed_from_ = recollection.until();
  left_ = recollection.left();
  lines_ = std::min(recollection.lines(), config_.memory->lines_told());
  sends_ = recollection.sends();
  for (const auto& [peer, reachable] : recollection.reachable()) heard_.insert(peer);
  for (const NodeNumber peer : roster_.peers_of(self_)) {
    if (!blackboard_.knows(peer)) continue;
    const std::uint64_t settled = blackboard_.settled(peer);
    unsettled_[{peer, false}] = {settled, settled + 1};
    const std::uint64_t settled_long = blackboard_.settled_long(peer);
    unsettled_[{peer, true}] = {settled_long, settled_long + 1};
  }
  node_due_ = node_->next_wakeup();
  (void)config_.memory->append({*resumed_from_, Resumed{}});
  return {};
}

// Its own lines and what it sent are of no account any more: it is another life.
Result<void, Failure> Host::recall_the_world() {
  Recollection recollection(*node_, nullptr, {});
  config_.memory->told(0);
  if (auto recalled = recollection.run(*config_.memory); !recalled) return recalled;
  resumed_from_ = recollection.until();
  left_ = recollection.left_of_the_world();
  node_due_ = node_->next_wakeup();
  return {};
}

void Host::remember(LoggedInput input, Now now) {
  if (config_.memory == nullptr) return;
  const MissionTime at = std::max(now.mission, resumed_from_.value_or(now.mission));
  const auto kept = config_.memory->append({at, std::move(input)});
  if (std::string news = config_.memory->take_news(); !news.empty())
    log(lines::Notice{.text = std::move(news)}, now);
  if (kept.has_value() != forgetful_) return;
  forgetful_ = !kept;
  log(lines::Notice{.text = kept ? "what happens is kept again"
                                 : "what happens is not kept: " + kept.error().why +
                                       "; it is held, and written once that is mended"},
      now);
}

void Host::lines_have_left() {
  if (config_.memory != nullptr && config_.memory->lines_told() != lines_)
    config_.memory->told(lines_);
}

void Host::job_done(JobDone done, Now now) { give(std::move(done), now); }

void Host::publish(wire::Sample sample, Now now) {
  if (!config_.world) return;
  const wire::Slot slot = wire::slot_of(sample);
  const auto sent = blackboard_.publish(std::move(sample), now);
  if (!sent) log_unsent(slot, "world", sent.error(), now);
}

void Host::say(const Member& from, wire::Sample sample, Now now) {
  if (!started_) return;
  wire::SampleHeader& header = wire::header_of(sample);
  header.origin = from.number.value();
  header.incarnation = config_.incarnation;
  header.sequence_number = ++said_;
  header.mission_time = now.mission.count();
  if (wire::find_violation(sample)) {
    return log_unsent(wire::slot_of(sample), self_.name, blackboard::Refusal::kMalformed, now);
  }
  give(Received{from.number, std::move(sample)}, now);
}

bool Host::all_peers_heard() const {
  return std::ranges::all_of(roster_.peers_of(self_), [&](NodeNumber peer) {
    if (heard_.contains(peer) || down_.contains(peer)) return true;
    return others_are_down_ && is_radio_peer(roster_, peer) &&
           !told_.contains({peer, self_.number});
  });
}

// A life begins no earlier than the one before it ended, whatever the clock says.
void Host::give(const Input& input, Now now) {
  if (resumed_from_) now.mission = std::max(now.mission, *resumed_from_);
  if (config_.memory != nullptr) remember(logged(input), now);
  const auto* received = std::get_if<Received>(&input);
  if (ports_.witness && received != nullptr) ports_.witness(received->sample);
  Effects effects = node_->handle(input, now.mission);
  node_due_ = node_->next_wakeup();
  carry_out(std::move(effects), now);
  for (const Undelivered& one : std::exchange(refused_, {})) give(one, now);
}

void Host::carry_out(Effects effects, Now now) {
  for (Effect& effect : effects) {
    std::visit(Overloaded{[&](Send& one) {
                            if (ports_.witness) ports_.witness(one.sample);
                            send(one, now);
                          },
                          [&](Publish& one) {
                            if (ports_.witness) ports_.witness(one.sample);
                            publish(std::move(one.sample), now);
                          },
                          [&](Log& one) {
                            ++lines_;
                            ports_.journal(one.record, {lines_, gives_out_again_});
                          },
                          [&](StartJob& one) { ports_.start_job(std::move(one)); },
                          [&](StopJob& one) {
                            if (ports_.stop_job) ports_.stop_job(one);
                          },
                          [&](Finish&) { ports_.finish(); }},
               effect);
  }
}

void Host::send(const Send& one, Now now) {
  const wire::Slot slot = wire::slot_of(one.sample);
  const auto sent = blackboard_.send(one.sample, one.to, now, {one.expires, one.receipt});
  const std::uint64_t number = sends_++;
  if (!sent) {
    const auto why = sent.error();
    if (why == blackboard::Refusal::kFull || why == blackboard::Refusal::kTooLong)
      remember(Unsent{number}, now);
    log_unsent(slot, roster_.name_of(one.to), sent.error(), now);
    if (one.receipt != 0) refused_.push_back({one.to, slot, 0, one.receipt, false});
    return;
  }
  if (config_.memory != nullptr && wire::slot_class(slot) == wire::SlotClass::kEvent)
    unsettled_[{one.to, *sent >= blackboard::kFirstLongEvent}].last = *sent;
  const bool radio = is_radio_peer(roster_, one.to) && is_radio_peer(roster_, self_.number);
  if (radio && wire::slot_class(slot) == wire::SlotClass::kEvent) {
    log_message(one.sample, self_.name, roster_.name_of(one.to), *sent, "sent", now);
  }
}

// What a peer has is noted once it is known: a peer that comes back with nothing it knew while this
// node is dead would else be sent again what its former life has done.
void Host::note_settled(Now now) {
  if (!started_) return;
  for (auto one = unsettled_.begin(); one != unsettled_.end();) {
    auto& [session, events] = *one;
    const auto& [peer, is_long] = session;
    const std::uint64_t settled =
        is_long ? blackboard_.settled_long(peer) : blackboard_.settled(peer);
    if (settled > events.noted) {
      events.noted = settled;
      remember(Acknowledged{peer, settled}, now);
    }
    one = settled >= events.last ? unsettled_.erase(one) : std::next(one);
  }
}

void Host::take(blackboard::Incoming incoming, Now now) {
  const auto* reach = std::get_if<blackboard::Reachability>(&incoming);
  if (reach != nullptr && reach->reachable) heard_.insert(reach->peer);
  if (!started_ && !is_of_the_world(incoming)) {
    before_start_.push_back(std::move(incoming));
    return;
  }
  std::visit(
      Overloaded{
          [&](blackboard::Received& one) { take_received(std::move(one), now); },
          [&](blackboard::Reachability& one) {
            log(lines::Reach{roster_.name_of(one.peer), one.reachable}, now);
            give(Reachability{one.peer, one.reachable, one.restarted}, now);
          },
          [&](blackboard::Dropped& one) {
            if (!one.first) return;
            log(lines::Dropped{.slot = wire::slot_name(one.slot),
                               .origin = roster_.name_of(one.origin),
                               .field = one.field,
                               .why = one.why},
                now);
          },
          [&](blackboard::EventExpired& one) {
            log(lines::Expired{.slot = wire::slot_name(one.slot),
                               .to = roster_.name_of(one.to),
                               .sequence = one.sequence,
                               .from = roster_.name_of(one.from)},
                now);
            if (one.from == self_.number) {
              give(Undelivered{one.to, one.slot, one.sequence, one.receipt, one.may_have_arrived},
                   now);
            } else {
              remember(skipped(one.slot, one.from, one.incarnation, one.sequence), now);
            }
          },
          [&](blackboard::RouteChanged& one) { log_route(one, now); },
          [&](blackboard::EventDelivered& one) {
            give(Delivered{one.to, one.receipt}, now);
          },
          [&](blackboard::EventsLost& one) {
            log(lines::Lost{.slot = "*",
                            .to = roster_.name_of(one.to),
                            .sequence = one.first,
                            .last = one.last,
                            .from = roster_.name_of(one.from)},
                now);
            remember(skipped(wire::Slot::kTaskRequest, one.from, one.incarnation, one.last), now);
          },
          [&](blackboard::TakenForOlder& one) { log_older(one, now); },
          [&](blackboard::TransportRefused& one) {
            log(lines::Transport{one.channel.partition, one.why}, now);
          }},
      incoming);
}

void Host::take_received(blackboard::Received received, Now now) {
  if (received.channel == ChannelKind::kWorld) {
    if (ports_.world) ports_.world(received.sample);
    if (!started_ || !is_for_nodes(wire::slot_of(received.sample))) return;
    return give(Received{received.origin, std::move(received.sample)}, now);
  }
  const wire::Slot slot = wire::slot_of(received.sample);
  if (received.channel == ChannelKind::kRadio &&
      wire::slot_class(slot) == wire::SlotClass::kEvent) {
    log_message(received.sample, roster_.name_of(received.origin), self_.name,
                wire::header_of(received.sample).sequence_number, "received", now);
  }
  give(Received{received.origin, std::move(received.sample)}, now);
}

void Host::apply_links(const std::vector<blackboard::Incoming>& incoming, Now now) {
  if (config_.told == ToldOfLinks::kNothing) return;
  for (const blackboard::Incoming& one : incoming) {
    const auto* received = std::get_if<blackboard::Received>(&one);
    if (received == nullptr) continue;
    const auto* link = std::get_if<wire::LinkState>(&received->sample);
    if (link == nullptr) continue;
    blackboard::is_of_one(*link) ? apply(*link, now) : apply_to_others(*link, now);
  }
}

void Host::apply(const wire::LinkState& link, Now now) {
  const NodeNumber from(link.from);
  const NodeNumber to(link.to);
  if (from != self_.number && to != self_.number) return;
  told_.insert({from, to});
  if (!link.up && config_.told == ToldOfLinks::kNotOfCuts) return;
  const NodeNumber peer = from == self_.number ? to : from;
  const blackboard::ChannelCondition condition = condition_of(link);
  if (condition.up) {
    down_.erase(peer);
  } else {
    down_.insert(peer);
  }
  blackboard_.set_condition(from, to, condition, now);
}

void Host::apply_to_others(const wire::LinkState& link, Now now) {
  if (!link.up && config_.told == ToldOfLinks::kNotOfCuts) return;
  const blackboard::ChannelCondition condition = condition_of(link);
  others_are_down_ = !condition.up;
  for (const NodeNumber peer : roster_.peers_of(self_)) {
    if (!is_radio_peer(roster_, peer) || !is_radio_peer(roster_, self_.number)) continue;
    if (!blackboard_.knows(peer)) continue;
    for (const auto& [from, to] : {std::pair(self_.number, peer), std::pair(peer, self_.number)})
      if (!told_.contains({from, to})) blackboard_.set_condition(from, to, condition, now);
  }
}

// Whoever says what nobody's radio is, be it in the name of the simulator, is taken at the nearest
// that one may be: what follows from it is reckoned with.
blackboard::ChannelCondition Host::condition_of(const wire::LinkState& link) const {
  constexpr std::int64_t kLongest = 3'600'000'000'000;  // [ns]
  constexpr double kNarrowest = 1;                      // [bit/s]
  const auto latency = std::clamp<std::int64_t>(link.latency, 0, kLongest);
  blackboard::ChannelCondition condition;
  condition.up = link.up;
  condition.latency = Duration::seconds(static_cast<double>(latency) * 1e-9 / config_.rate);
  condition.loss = link.loss > 0 ? std::min(link.loss, 1.0) : 0;
  const bool is_limited = link.capacity > 0 && std::isfinite(link.capacity);
  const double capacity = is_limited ? std::max(link.capacity, kNarrowest) : 0;
  condition.capacity = capacity * config_.rate * config_.share_of_samples;
  return condition;
}

}  // namespace skein::node
