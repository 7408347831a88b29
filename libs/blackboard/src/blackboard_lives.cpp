// SPDX-License-Identifier: Apache-2.0
// Which life of this node its peers take it for, where it can only guess; two processes with the
// number of one node.
#include <algorithm>
#include <limits>

#include "blackboard_impl.hpp"

namespace skein::blackboard {
namespace {

const wire::Violation kSecond{"header.incarnation",
                              "is of a second node with this name, while the first is heard"};

const wire::Violation kOlderSecond{"header.incarnation",
                                   "is an older one: a second node has this name"};

}  // namespace

std::uint64_t Blackboard::Impl::incarnation_for(NodeNumber to) const {
  const auto found = config_.guesses_incarnation ? peers_.find(to) : peers_.end();
  return found == peers_.end() ? incarnation_ : found->second.self_incarnation();
}

void Blackboard::Impl::compare_lives(Peer& peer, const wire::Heartbeat& heartbeat, Now now) {
  if (heartbeat.header.incarnation < peer.incarnation()) {
    if (peer.is_former(heartbeat.header.incarnation)) return;
    peer.on_old_heartbeat();
    if (peer.has_older_rival()) refuse(wire::Slot::kHeartbeat, heartbeat.header, kOlderSecond);
    return;
  }
  const std::uint64_t heard = heartbeat.ack_incarnation;
  if (heard <= peer.self_incarnation()) return;
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
  // Whom the peer has heard, and hears no more, has a rival: two that climb over each other would
  // never end.
  const bool is_next = config_.guesses_incarnation && !peer.was_heard() && heard < kLast;
  if (!is_next && !takers_for_older_.insert(peer.channels().number).second) return;
  out_.emplace_back(TakenForOlder{peer.channels().number, heard, is_next});
  if (is_next) become(peer, heard + 1, now);
}

Peer* Blackboard::Impl::speaker(std::size_t channel, const wire::SampleHeader& header) {
  Peer* sender = senders_[channel];
  if (sender != nullptr && sender->channels().number.value() == header.origin) return sender;
  const auto found = peers_.find(NodeNumber(header.origin));
  return found == peers_.end() ? nullptr : &found->second;
}

bool Blackboard::Impl::is_of_second(std::size_t channel, const wire::SampleHeader& header,
                                    Now now) {
  Peer* peer = speaker(channel, header);
  if (peer == nullptr || !peer->refuses(header.incarnation, now.steady)) return false;
  refuse(wire::Slot::kHeartbeat, header, kSecond);
  return true;
}

void Blackboard::Impl::return_to_first(Peer& peer, const wire::SampleHeader& header, Now now) {
  refuse(wire::Slot::kHeartbeat, header, kSecond);
  freshness_.return_to(header.origin, peer.incarnation());
  if (forwarding_) forwarding_->forget(peer.channels().number);
  ask_for_last_values(peer, now);
}

void Blackboard::Impl::ask_for_last_values(const Peer& peer, Now now) {
  if (!peer.incoming_condition().up) return;
  const std::size_t incoming = peer.channels().incoming;
  connections_.set_up(incoming, false, now.steady, out_);
  connections_.set_up(incoming, true, now.steady, out_);
}

void Blackboard::Impl::note_older_life(std::size_t channel, const Peer& peer, wire::Slot slot,
                                       const wire::SampleHeader& header) {
  if (peer.has_older_rival()) return refuse(wire::Slot::kHeartbeat, header, kOlderSecond);
  note_replay(channel, slot, header);
}

// With relays a sample may be overtaken by others that go another way.
void Blackboard::Impl::note_replay(std::size_t channel, wire::Slot slot,
                                   const wire::SampleHeader& header) {
  const bool is_direct = config_.channels[channel].from.value() == header.origin;
  if (forwarding_ || !is_direct || !header.via.empty()) return;
  refuse(slot, header, {"header.sequence_number", "is of a sample that was replayed"});
}

void Blackboard::Impl::become(Peer& peer, std::uint64_t incarnation, Now now) {
  const NodeNumber number = peer.channels().number;
  peer.become(incarnation, now.steady);
  const bool world_too = incarnation > incarnation_;
  incarnation_ = std::max(incarnation_, incarnation);
  for (const auto& [key, kept] : std::map(own_states_)) {
    const NodeNumber to = std::get<NodeNumber>(key);
    if (to != number && !(world_too && to == kEverybody)) continue;
    wire::Sample state = kept;
    wire::header_of(state).incarnation = incarnation_for(to);
    wire::header_of(state).sequence_number = ++sequence_;
    if (to == number) {
      send_value(peer, std::move(state), now);
    } else {
      write(*world_, state);
    }
  }
  serve(peer, now);
}

}  // namespace skein::blackboard
