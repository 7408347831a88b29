// SPDX-License-Identifier: Apache-2.0
// How samples go past relays, at their ends and in between.
#include <algorithm>

#include "blackboard_impl.hpp"
#include "routing/path_violation.hpp"

namespace skein::blackboard {
namespace {

using routing::has_passed;

bool is_state(wire::Slot slot) { return wire::slot_class(slot) == wire::SlotClass::kState; }

}  // namespace

Peer* Blackboard::Impl::hop_to(NodeNumber to, wire::Slot slot) {
  const auto found = peers_.find(router_ ? router_->next_hop(to) : to);
  if (found == peers_.end()) return nullptr;
  const bool carried = slot == wire::Slot::kHeartbeat ||
                       config_.channels[found->second.channels().outgoing].carries(slot);
  return carried ? &found->second : nullptr;
}

// What does not wait in the channel waits in the transport (states), with its sender (events), or
// is of the past (streams).
void Blackboard::Impl::hand_to(Peer& hop, wire::Sample sample, Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const bool up = hop.outgoing_condition().up;
  LimitedChannel* limited = hop.limited();
  if (!up || limited == nullptr) {
    if (up || is_state(slot)) write(hop.channels().outgoing, sample);
    return;
  }
  const bool each = slot == wire::Slot::kHeartbeat || slot == wire::Slot::kPart ||
                    wire::slot_class(slot) == wire::SlotClass::kEvent;
  if (each) {
    limited->pass(std::move(sample));
  } else {
    limited->put(std::move(sample));
  }
  write_in_turn(hop, now);
  plan(hop);
}

void Blackboard::Impl::send_on(NodeNumber to, wire::Sample sample, Now now) {
  if (Peer* hop = hop_to(to, wire::slot_of(sample))) hand_to(*hop, std::move(sample), now);
}

void Blackboard::Impl::send_past_relays(wire::Heartbeat heartbeat, Now now) {
  const NodeNumber to(heartbeat.header.destination);
  if (!router_ || !router_->is_relayed(to)) return;
  heartbeat.header.instance = kPastRelays;
  send_on(to, std::move(heartbeat), now);
}

// A state is written on the direct channel in any case: there it waits for the link.
void Blackboard::Impl::send_value(Peer& peer, wire::Sample sample, Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const NodeNumber to = peer.channels().number;
  if ((router_ || config_.guesses_incarnation) && is_state(slot))
    own_states_.insert_or_assign(OwnStateKey{to, slot, wire::header_of(sample).instance}, sample);
  const bool relayed = router_ && router_->is_relayed(to);
  if (relayed) send_on(to, sample, now);
  if (!relayed || is_state(slot)) hand_to(peer, std::move(sample), now);
}

// The receiver knows what it has handled, the sender what it holds: a relay decides by what is
// worth the radio only.
void Blackboard::Impl::pass_on(const ChannelConfig& from, wire::Sample sample, Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  wire::SampleHeader& header = wire::header_of(sample);
  const NodeNumber to(header.destination);
  if (from.kind != ChannelKind::kRadio || !router_ || !router_->relays()) return;
  if (!peers_.contains(to)) return;
  if (header.via.size() >= config_.relaying.most_relays || !passed_on_.admit(sample)) return;
  header.via.push_back(config_.self.value());
  if (is_state(slot)) passed_on_.keep(sample);
  const NodeNumber next = router_->next_hop(to);
  if (next == from.from || has_passed(header, next) || !router_->reaches(to)) return;
  send_on(to, std::move(sample), now);
}

void Blackboard::Impl::learn(wire::Neighbours report, Now now) {
  if (!router_) return;
  router_->on_report(report);
  // Who had passed it on in a former life leaves out the detour.
  std::vector<std::uint32_t>& via = report.header.via;
  via.erase(std::ranges::find(via, config_.self.value()), via.end());
  if (!router_->relays() || via.size() >= config_.relaying.most_relays) return;
  via.push_back(config_.self.value());
  flood(report, now);
  reports_.insert_or_assign(NodeNumber(report.header.origin), std::move(report));
}

// Who comes back may have forgotten what it passed on itself; the rest the channel has kept for it.
void Blackboard::Impl::remind(NodeNumber peer, Now now) {
  for (const auto& [author, report] : reports_) {
    if (author != peer && has_passed(report.header, peer)) hand_to(peers_.at(peer), report, now);
  }
}

void Blackboard::Impl::flood(const wire::Neighbours& report, Now now) {
  for (Peer* radio_peer : radio_peers_) {
    Peer& peer = *radio_peer;
    const NodeNumber number = peer.channels().number;
    if (number.value() == report.header.origin || has_passed(report.header, number)) continue;
    hand_to(peer, report, now);
  }
}

void Blackboard::Impl::route(Now now) {
  if (!router_) return;
  for (const routing::WayChange& change : router_->update(now.steady)) take_way(change, now);
  for (const NodeNumber peer : router_->take_new_links()) remind(peer, now);
  if (auto report = router_->take_report()) {
    stamp(report->header, kEverybody, ++sequence_, now);
    flood(*report, now);
  }
}

// Events and states may have been under way on the way before.
void Blackboard::Impl::take_way(const routing::WayChange& change, Now now) {
  const auto found = peers_.find(change.peer);
  if (found == peers_.end()) return;
  Peer& peer = found->second;
  const bool relayed = change.way && change.way->relays > 0;
  const auto told = told_.find(change.peer);
  const bool was_relayed = told != told_.end();
  const bool is_new = relayed != was_relayed || (relayed && told->second != *change.way);
  const bool is_other =
      relayed != was_relayed || (relayed && told->second.next != change.way->next);
  peer.set_way(relayed ? change.way->relays : 0, change.heard_of, is_other, now);
  if (relayed) {
    told_.insert_or_assign(change.peer, *change.way);
  } else {
    told_.erase(change.peer);
  }
  if (is_new) {
    out_.emplace_back(relayed ? RouteChanged{change.peer, change.way->next, change.way->relays}
                              : RouteChanged{change.peer, std::nullopt, 0});
  }
  resend_states(change, now);
  serve(peer, now);
}

void Blackboard::Impl::resend_states(const routing::WayChange& change, Now now) {
  if (!change.way) return;
  if (change.way->relays > 0) {
    for (auto one = own_states_.lower_bound({change.peer, wire::Slot{}, 0});
         one != own_states_.end() && std::get<0>(one->first) == change.peer; ++one) {
      send_on(change.peer, one->second, now);
    }
  }
  for (const wire::Sample& state : passed_on_.states_for(change.peer)) {
    if (!has_passed(wire::header_of(state), change.way->next)) send_on(change.peer, state, now);
  }
}

}  // namespace skein::blackboard
