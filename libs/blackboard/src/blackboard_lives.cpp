// SPDX-License-Identifier: Apache-2.0
// Which life of this node its peers take it for, where it can only guess; two processes with the
// number of one node, also on the world channel.
#include <limits>

#include "blackboard_impl.hpp"

namespace skein::blackboard {

void Blackboard::Impl::compare_lives(Peer& peer, const wire::Heartbeat& heartbeat, Now now) {
  if (heartbeat.header.incarnation < peer.incarnation()) {
    const bool is_former = peer.known().lives.is_former(heartbeat.header.incarnation);
    if (is_former && peer.reachable()) return;
    peer.on_old_heartbeat(heartbeat.header.incarnation, now.steady);
    if (peer.known().lives.has_older_rival())
      drops_.tell(wire::Slot::kHeartbeat, heartbeat.header, kOfOlderSecond, out_);
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

// What a peer publishes says nothing about the radio.
void Blackboard::Impl::admit_published(const Peer* peer, wire::Sample&& sample, Now now) {
  const wire::SampleHeader header = wire::header_of(sample);
  const auto* heartbeat = std::get_if<wire::Heartbeat>(&sample);
  if (peer != nullptr) {
    const bool is_new =
        heartbeat == nullptr && freshness_.admit(wire::slot_of(sample), header) == Novelty::kNew;
    if (is_new)
      out_.emplace_back(
          Received{NodeNumber(header.origin), ChannelKind::kWorld, std::move(sample)});
    return;
  }
  const auto refused = heartbeat != nullptr ? publishers_.hear(*heartbeat, now.steady, out_)
                                            : publishers_.take(std::move(sample), now.steady, out_);
  if (refused) drops_.tell(wire::Slot::kHeartbeat, header, *refused, out_);
}

// With relays a sample may be overtaken by others that go another way.
void Blackboard::Impl::note_replay(std::size_t channel, wire::Slot slot,
                                   const wire::SampleHeader& header) {
  const bool is_direct = config_.channels[channel].from.value() == header.origin;
  if (forwarding_ || !is_direct || !header.via.empty()) return;
  drops_.tell(slot, header, {"header.sequence_number", "is of a sample that was replayed"}, out_);
}

void Blackboard::Impl::become(Peer& peer, std::uint64_t incarnation, Now now) {
  const NodeNumber number = peer.channels().number;
  peer.become(incarnation, now.steady);
  const bool world_too = signature_.become(incarnation);
  for (const auto& [key, kept] : std::map(own_states_)) {
    const NodeNumber to = std::get<NodeNumber>(key);
    if (to != number && !(world_too && to == kEverybody)) continue;
    wire::Sample state = kept;
    signature_.renew(wire::header_of(state), to == number ? incarnation : signature_.incarnation());
    if (to == number) {
      send_value(peer, std::move(state), now);
    } else {
      write(*directory_.world(), state);
    }
  }
  serve(peer, now);
}

}  // namespace skein::blackboard
