// SPDX-License-Identifier: Apache-2.0
// Events that are too long to be said at once, as they go out and come in.
#include "blackboard_impl.hpp"

namespace skein::blackboard {

namespace {

/// What is wrong with an event that came in parts over that channel, as the channel would find.
std::optional<wire::Violation> long_event_violation(const ChannelConfig& channel,
                                                    const wire::Part& part,
                                                    const wire::Sample& event) {
  if (auto violation = wire::find_violation(event)) return violation;
  const wire::SampleHeader& header = wire::header_of(event);
  const bool fits = header.origin == part.header.origin &&
                    header.destination == part.header.destination &&
                    header.incarnation == part.header.incarnation &&
                    header.sequence_number == part.number && header.via.empty();
  if (!fits) return wire::Violation{"header", "is another one than its parts have"};
  if (channel.originates(wire::slot_of(event))) return std::nullopt;
  return wire::Violation{"header.origin", "has nothing of its own to say in this slot"};
}

}  // namespace

void Blackboard::Impl::write_parts(Peer& peer, Now now) {
  const NodeNumber to = peer.channels().number;
  while (auto part = peer.take_part(now)) {
    stamp(part->header, to, ++sequence_, now);
    if (is_relayed(to)) {
      send_on(to, std::move(*part), now);
    } else {
      write(peer.channels().outgoing, *part);
    }
  }
}

void Blackboard::Impl::admit_part(Peer& peer, const wire::Part& part, Now now) {
  auto event = peer.on_part(part, now, out_);
  hear(peer);
  if (!event) return;
  const auto* malformed = std::get_if<Malformed>(&*event);
  if (malformed != nullptr) return refuse(malformed->slot, part.header, malformed->violation);
  auto& sample = std::get<wire::Sample>(*event);
  const wire::SampleHeader header = wire::header_of(sample);
  const wire::Slot slot = wire::slot_of(sample);
  if (const auto violation =
          long_event_violation(config_.channels[peer.channels().incoming], part, sample))
    return refuse(slot, part.header, *violation);
  if (header.expires < now.mission.count()) {
    out_.emplace_back(EventExpired{slot, NodeNumber(header.origin), NodeNumber(header.destination),
                                   header.sequence_number, header.incarnation});
    return;
  }
  out_.emplace_back(Received{NodeNumber(header.origin), peer.channels().kind, std::move(sample)});
}

}  // namespace skein::blackboard
