// SPDX-License-Identifier: Apache-2.0
// Events and states that are too long to be said at once, as they go out and come in.
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

Incoming received_or_expired(wire::Sample event, ChannelKind kind, MissionTime now) {
  const wire::SampleHeader header = wire::header_of(event);
  if (header.expires < now.count())
    return EventExpired{wire::slot_of(event), NodeNumber(header.origin),
                        NodeNumber(header.destination), header.sequence_number, header.incarnation};
  return Received{NodeNumber(header.origin), kind, std::move(event)};
}

}  // namespace

// A state is as if it had come whole over that channel.
void Blackboard::Impl::admit_part(std::size_t channel, Peer& peer, const wire::Part& part,
                                  Now now) {
  auto whole = peer.on_part(part, now, out_);
  hear(peer);
  if (!whole) return;
  const auto* malformed = std::get_if<Malformed>(&*whole);
  if (malformed != nullptr)
    return drops_.tell(malformed->slot, part.header, malformed->violation, out_);
  auto& sample = std::get<wire::Sample>(*whole);
  const wire::Slot slot = wire::slot_of(sample);
  if (wire::slot_class(slot) == wire::SlotClass::kState) {
    const wire::SampleHeader& header = wire::header_of(sample);
    if (header.origin == config_.self.value()) return;  // a relay sends it back: our own
    freshness_.note_parts(slot, header);
    return admit(channel, std::move(sample), now);
  }
  if (const auto violation =
          long_event_violation(config_.channels[peer.channels().incoming], part, sample))
    return drops_.tell(slot, part.header, *violation, out_);
  out_.push_back(received_or_expired(std::move(sample), peer.channels().kind, now.mission));
}

}  // namespace skein::blackboard
