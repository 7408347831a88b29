// SPDX-License-Identifier: Apache-2.0
#include "skein/node/host.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::node {

namespace {

using blackboard::ChannelKind;
using blackboard::Now;

bool is_radio_peer(const Roster& roster, NodeNumber number) {
  const Member* member = roster.find(number);
  return member != nullptr &&
         (member->role == wire::Role::kGround || member->role == wire::Role::kDdn);
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

bool is_of_the_world(const blackboard::Incoming& incoming) {
  const auto* received = std::get_if<blackboard::Received>(&incoming);
  return received != nullptr && received->channel == ChannelKind::kWorld;
}

}  // namespace

Result<std::unique_ptr<Host>, Failure> Host::open(const Roster& roster, const Member& self,
                                                  std::unique_ptr<Node> node,
                                                  blackboard::Transport& transport,
                                                  const HostConfig& config, HostPorts ports) {
  blackboard::Config board;
  board.self = self.number;
  board.incarnation = config.incarnation;
  board.channels = roster.channels_of(self);
  if (config.leads_clock) add_clock(board.channels);
  board.world_reads = Roster::world_reads_of(self.role);
  board.heartbeat_period = config.heartbeat_period;
  board.retransmission =
      Duration::nanoseconds(config.heartbeat_period.count() + config.heartbeat_period.count() / 2);
  board.seed = config.seed;
  auto opened = blackboard::Blackboard::open(std::move(board), transport);
  if (!opened) return tl::unexpected(opened.error());
  return std::unique_ptr<Host>(
      new Host(roster, self, std::move(node), std::move(*opened), config, std::move(ports)));
}

Host::Host(const Roster& roster, const Member& self, std::unique_ptr<Node> node,
           blackboard::Blackboard blackboard, const HostConfig& config, HostPorts ports)
    : roster_(roster),
      self_(self),
      node_(std::move(node)),
      blackboard_(std::move(blackboard)),
      config_(config),
      ports_(std::move(ports)),
      node_due_(node_->next_wakeup()) {
  for (const auto& channel : roster_.channels_of(self_)) {
    if (channel.kind == ChannelKind::kWorld) continue;
    peers_.insert(channel.from == self_.number ? channel.to : channel.from);
  }
}

void Host::start(Now now) {
  SKEIN_EXPECTS(!started_);
  started_ = true;
  give(Started{config_.incarnation}, now);
  for (auto& incoming : std::exchange(before_start_, {})) take(std::move(incoming), now);
}

bool Host::step(Now now) {
  std::vector<blackboard::Incoming> incoming = blackboard_.step(now);
  bool busy = !incoming.empty();
  for (auto& one : incoming) take(std::move(one), now);
  if (started_ && node_due_ && *node_due_ <= now.mission) {
    give(Wakeup{}, now);
    busy = true;
  }
  return busy;
}

void Host::job_done(JobDone done, Now now) { give(std::move(done), now); }

void Host::publish(wire::Sample sample, Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const auto sent = blackboard_.publish(std::move(sample), now);
  if (!sent) log_unsent(slot, "world", sent.error(), now);
}

bool Host::all_peers_heard() const {
  return std::all_of(peers_.begin(), peers_.end(), [&](NodeNumber peer) {
    return heard_.count(peer) > 0 || down_.count(peer) > 0;
  });
}

void Host::give(const Input& input, Now now) {
  Effects effects = node_->handle(input, now.mission);
  node_due_ = node_->next_wakeup();
  carry_out(std::move(effects), now);
}

void Host::carry_out(Effects effects, Now now) {
  for (Effect& effect : effects) {
    std::visit(Overloaded{[&](Send& one) { send(one, now); },
                          [&](Publish& one) { publish(std::move(one.sample), now); },
                          [&](Log& one) { ports_.journal(one.record); },
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
  const auto sent = blackboard_.send(one.sample, one.to, now, {one.expires});
  if (!sent) {
    log_unsent(slot, roster_.name_of(one.to), sent.error(), now);
    return;
  }
  const bool radio = is_radio_peer(roster_, one.to) && is_radio_peer(roster_, self_.number);
  if (radio && wire::slot_class(slot) == wire::SlotClass::kEvent) {
    log_message(slot, self_.name, roster_.name_of(one.to), *sent, "sent", now);
  }
}

void Host::take(blackboard::Incoming incoming, Now now) {
  const auto* reach = std::get_if<blackboard::Reachability>(&incoming);
  if (reach != nullptr && reach->reachable) heard_.insert(reach->peer);
  if (!started_ && !is_of_the_world(incoming)) {
    before_start_.push_back(std::move(incoming));
    return;
  }
  std::visit(Overloaded{[&](blackboard::Received& one) { take_received(std::move(one), now); },
                        [&](blackboard::Reachability& one) {
                          ports_.journal(record("reach", now)
                                             .with("peer", roster_.name_of(one.peer))
                                             .with("reachable", one.reachable));
                          give(Reachability{one.peer, one.reachable, one.restarted}, now);
                        },
                        [&](blackboard::Dropped& one) {
                          if (!one.first) return;
                          ports_.journal(record("dropped", now)
                                             .with("slot", wire::slot_name(one.slot))
                                             .with("origin", roster_.name_of(one.origin))
                                             .with("field", one.field)
                                             .with("why", one.why));
                        },
                        [&](blackboard::EventExpired& one) {
                          ports_.journal(record("expired", now)
                                             .with("slot", wire::slot_name(one.slot))
                                             .with("to", roster_.name_of(one.to))
                                             .with("sequence", one.sequence));
                          if (one.from == self_.number)
                            give(Undelivered{one.to, one.slot, one.sequence}, now);
                        },
                        [&](blackboard::EventsLost& one) {
                          ports_.journal(record("lost", now)
                                             .with("slot", "*")
                                             .with("to", roster_.name_of(one.to))
                                             .with("sequence", one.first)
                                             .with("last", one.last)
                                             .with("from", roster_.name_of(one.from)));
                        }},
             incoming);
}

void Host::take_received(blackboard::Received received, Now now) {
  if (const auto* link = std::get_if<wire::LinkState>(&received.sample)) apply(*link, now);
  if (received.channel == ChannelKind::kWorld) {
    if (ports_.world) ports_.world(received.sample);
    // Where vehicles are that others play is for the node.
    if (!started_ || !std::holds_alternative<wire::Truth>(received.sample)) return;
    return give(Received{received.origin, std::move(received.sample)}, now);
  }
  const wire::Slot slot = wire::slot_of(received.sample);
  if (received.channel == ChannelKind::kRadio &&
      wire::slot_class(slot) == wire::SlotClass::kEvent) {
    log_message(slot, roster_.name_of(received.origin), self_.name,
                wire::header_of(received.sample).sequence_number, "received", now);
  }
  give(Received{received.origin, std::move(received.sample)}, now);
}

void Host::apply(const wire::LinkState& link, Now now) {
  const NodeNumber from(link.from);
  const NodeNumber to(link.to);
  if (from != self_.number && to != self_.number) return;
  const NodeNumber peer = from == self_.number ? to : from;
  if (link.up) {
    down_.erase(peer);
  } else {
    down_.insert(peer);
  }
  blackboard::ChannelCondition condition;
  condition.up = link.up;
  condition.latency = Duration::seconds(static_cast<double>(link.latency) * 1e-9 / config_.rate);
  condition.loss = link.loss;
  blackboard_.set_condition(from, to, condition, now);
}

void Host::log_unsent(wire::Slot slot, const std::string& to, blackboard::Refusal why, Now now) {
  ports_.journal(record("unsent", now)
                     .with("slot", wire::slot_name(slot))
                     .with("to", to)
                     .with("why", blackboard::name_of(why)));
}

void Host::log_message(wire::Slot slot, const std::string& from, const std::string& to,
                       std::uint64_t sequence, const char* direction, Now now) {
  ports_.journal(record("message", now)
                     .with("slot", wire::slot_name(slot))
                     .with("from", from)
                     .with("to", to)
                     .with("sequence", sequence)
                     .with("direction", direction));
}

journal::Record Host::record(const char* kind, Now now) const {
  return {now.mission, self_.name, kind};
}

}  // namespace skein::node
