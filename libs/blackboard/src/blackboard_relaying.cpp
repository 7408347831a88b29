// SPDX-License-Identifier: Apache-2.0
// How samples are written, past relays or not.
#include <utility>

#include "blackboard_impl.hpp"

namespace skein::blackboard {
namespace {

bool is_state(wire::Slot slot) { return wire::slot_class(slot) == wire::SlotClass::kState; }

}  // namespace

// What does not wait in the channel waits in the transport (states where there is no channel that
// takes turns), with its sender (events), or is of the past (streams).
void Blackboard::Impl::hand_to(Peer& hop, wire::Sample sample, Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const bool up = hop.line().outgoing().up;
  if (hop.line().limited() == nullptr) {
    if (is_state(slot)) hop.pass_by(sample);
    if (up || is_state(slot)) write(hop.channels().outgoing, sample);
    return;
  }
  if (!up) {
    if (is_state(slot)) hop.put(std::move(sample));
    return;
  }
  hop.put(std::move(sample));
  write_in_turn(hop, now);
  directory_.plan(hop);
}

void Blackboard::Impl::hand_all(std::vector<routing::Handed> handed, Now now) {
  for (routing::Handed& one : handed) hand_to(directory_.at(one.hop), std::move(one.sample), now);
}

void Blackboard::Impl::send_on(NodeNumber to, wire::Sample sample, Now now) {
  if (const auto hop = forwarding_->hop_to(to, wire::slot_of(sample)))
    hand_to(directory_.at(*hop), std::move(sample), now);
}

void Blackboard::Impl::send_past_relays(wire::Heartbeat heartbeat, Now now) {
  const NodeNumber to(heartbeat.header.destination);
  if (!is_relayed(to)) return;
  heartbeat.header.instance = kPastRelays;
  send_on(to, std::move(heartbeat), now);
}

// A state is written on the direct channel in any case: there it waits for the link.
void Blackboard::Impl::send_value(Peer& peer, wire::Sample sample, Now now) {
  const wire::Slot slot = wire::slot_of(sample);
  const NodeNumber to = peer.channels().number;
  if ((forwarding_ || config_.guesses_incarnation) && is_state(slot))
    own_states_.insert_or_assign(OwnStateKey{to, slot, wire::header_of(sample).instance}, sample);
  const bool relayed = is_relayed(to);
  if (relayed) send_on(to, sample, now);
  if (!relayed || is_state(slot)) hand_to(peer, std::move(sample), now);
}

void Blackboard::Impl::route(Now now) {
  if (!forwarding_) return;
  for (const routing::WayChange& change : forwarding_->update(now.steady)) take_way(change, now);
  hand_all(forwarding_->take_reminders(), now);
  if (auto report = forwarding_->take_report()) {
    signature_.sign_published(report->header, now);
    hand_all(forwarding_->flood(*report), now);
  }
}

// Events and states may have been under way on the way before.
void Blackboard::Impl::take_way(const routing::WayChange& change, Now now) {
  Peer* found = directory_.find(change.peer);
  if (found == nullptr) return;
  Peer& peer = *found;
  const routing::TakenWay taken = forwarding_->take(change);
  peer.set_way(taken.relays, change.heard_of, taken.is_other, now);
  if (taken.news) out_.emplace_back(*taken.news);
  if (taken.relays > 0) {
    for (auto one = own_states_.lower_bound({change.peer, wire::Slot{}, 0});
         one != own_states_.end() && std::get<0>(one->first) == change.peer; ++one)
      send_on(change.peer, one->second, now);
  }
  hand_all(forwarding_->states_for(change), now);
  serve(peer, now);
}

}  // namespace skein::blackboard
