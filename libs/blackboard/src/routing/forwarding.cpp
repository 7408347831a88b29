// SPDX-License-Identifier: Apache-2.0
#include "routing/forwarding.hpp"

#include <algorithm>
#include <utility>

#include "routing/path_violation.hpp"

namespace skein::blackboard::routing {
namespace {

bool is_kept(wire::Slot slot) { return wire::slot_class(slot) == wire::SlotClass::kState; }

}  // namespace

Forwarding::Forwarding(const Config& config)
    : config_(config), router_(config.self, config.relaying.relays, config.heartbeat_period) {
  for (const ChannelConfig& channel : config.channels) {
    const bool to_a_peer = channel.kind != ChannelKind::kWorld && channel.from == config.self;
    if (to_a_peer) channels_.emplace(channel.to, &channel);
  }
}

std::optional<NodeNumber> Forwarding::hop_to(NodeNumber to, wire::Slot slot) const {
  const NodeNumber hop = router_.next_hop(to);
  const auto channel = channels_.find(hop);
  if (channel == channels_.end()) return std::nullopt;
  const bool carried = slot == wire::Slot::kHeartbeat || channel->second->carries(slot);
  return carried ? std::optional(hop) : std::nullopt;
}

// The receiver knows what it has handled, the sender what it holds: a relay decides by what is
// worth the radio only.
std::optional<Handed> Forwarding::pass_on(const ChannelConfig& from, wire::Sample sample) {
  const wire::Slot slot = wire::slot_of(sample);
  wire::SampleHeader& header = wire::header_of(sample);
  const NodeNumber to(header.destination);
  if (from.kind != ChannelKind::kRadio || !router_.relays()) return std::nullopt;
  if (!channels_.contains(to)) return std::nullopt;
  if (header.via.size() >= config_.relaying.most_relays || !passed_on_.admit(sample))
    return std::nullopt;
  header.via.push_back(config_.self.value());
  if (is_kept(slot)) passed_on_.keep(sample);
  const NodeNumber next = router_.next_hop(to);
  if (next == from.from || has_passed(header, next) || !router_.reaches(to)) return std::nullopt;
  const auto hop = hop_to(to, slot);
  if (!hop) return std::nullopt;
  return Handed{*hop, std::move(sample)};
}

std::vector<Handed> Forwarding::learn(wire::Neighbours report) {
  router_.on_report(report);
  // Who had passed it on in a former life leaves out the detour.
  std::vector<std::uint32_t>& via = report.header.via;
  via.erase(std::ranges::find(via, config_.self.value()), via.end());
  if (!router_.relays() || via.size() >= config_.relaying.most_relays) return {};
  via.push_back(config_.self.value());
  std::vector<Handed> told = flood(report);
  reports_.insert_or_assign(NodeNumber(report.header.origin), std::move(report));
  return told;
}

std::vector<Handed> Forwarding::flood(const wire::Neighbours& report) const {
  std::vector<Handed> told;
  for (const auto& [peer, channel] : channels_) {
    if (channel->kind != ChannelKind::kRadio) continue;
    if (peer.value() == report.header.origin || has_passed(report.header, peer)) continue;
    told.push_back({peer, report});
  }
  return told;
}

std::vector<Handed> Forwarding::take_reminders() {
  std::vector<Handed> reminders;
  for (const NodeNumber peer : router_.take_new_links())
    for (const auto& [author, report] : reports_)
      if (author != peer && has_passed(report.header, peer)) reminders.push_back({peer, report});
  return reminders;
}

TakenWay Forwarding::take(const WayChange& change) {
  const bool relayed = change.way && change.way->relays > 0;
  const auto told = told_.find(change.peer);
  const bool was_relayed = told != told_.end();
  const bool is_new = relayed != was_relayed || (relayed && told->second != *change.way);
  TakenWay taken;
  taken.relays = relayed ? change.way->relays : 0;
  taken.is_other = relayed != was_relayed || (relayed && told->second.next != change.way->next);
  if (is_new)
    taken.news = relayed ? RouteChanged{change.peer, change.way->next, taken.relays}
                         : RouteChanged{change.peer, std::nullopt, 0};
  if (relayed) {
    told_.insert_or_assign(change.peer, *change.way);
  } else {
    told_.erase(change.peer);
  }
  return taken;
}

std::vector<Handed> Forwarding::states_for(const WayChange& change) const {
  std::vector<Handed> states;
  if (!change.way) return states;
  for (wire::Sample& state : passed_on_.states_for(change.peer)) {
    if (has_passed(wire::header_of(state), change.way->next)) continue;
    const auto hop = hop_to(change.peer, wire::slot_of(state));
    if (hop) states.push_back({*hop, std::move(state)});
  }
  return states;
}

}  // namespace skein::blackboard::routing
