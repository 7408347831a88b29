// SPDX-License-Identifier: Apache-2.0
// The receiving half of an event session with one peer.
#include "sessions/incoming_events.hpp"

#include <algorithm>

#include "sessions/tombstone.hpp"

namespace skein::blackboard {
namespace {

/// Far more than a correct sender has under way; what does not fit is sent again.
constexpr std::size_t kBufferLimit = 4 * kEventDepth;

/// A transport gives its history again once for each contact; repetitions of the sender may be
/// under way when its heartbeat says that it has the acknowledgement.
constexpr std::uint32_t kInnocentRuns = 3;

}  // namespace

bool IncomingEvents::enter(std::uint64_t incarnation) {
  if (incarnation < incarnation_) return false;
  if (incarnation > incarnation_) {
    *this = IncomingEvents(self_, self_incarnation_);
    incarnation_ = incarnation;
  }
  return true;
}

Novelty IncomingEvents::on_event(const wire::SampleHeader& header,
                                 std::optional<wire::Sample> event) {
  // What is malformed may lie in its header too: it never opens a session nor waits for one.
  if (!event && (header.incarnation != incarnation_ || !open_)) return Novelty::kKnown;
  if (!enter(header.incarnation)) return Novelty::kKnown;
  const std::uint64_t sequence = header.sequence_number;
  if (open_ && sequence < next_) return handled_before(sequence);
  if (buffer_.size() >= kBufferLimit || (open_ && sequence - next_ >= kBufferLimit))
    return Novelty::kKnown;
  if (event) keep_places_before(wire::header_of(*event));
  return buffer_.emplace(sequence, std::move(event)).second ? Novelty::kNew : Novelty::kKnown;
}

void IncomingEvents::keep_places_before(const wire::SampleHeader& tombstone) {
  const std::uint64_t places = places_kept(tombstone.expires).value_or(1);
  const std::uint64_t most =
      std::min<std::uint64_t>({places, tombstone.sequence_number, kBufferLimit});
  for (std::uint64_t place = tombstone.sequence_number - (most - 1);
       place < tombstone.sequence_number; ++place)
    if (!open_ || place >= next_) buffer_.try_emplace(place);
}

Novelty IncomingEvents::handled_before(std::uint64_t sequence) {
  owes_ = true;
  if (sequence >= settled_) return Novelty::kKnown;
  if (sequence <= last_again_) ++runs_again_;
  last_again_ = sequence;
  return runs_again_ > kInnocentRuns ? Novelty::kReplayed : Novelty::kKnown;
}

void IncomingEvents::on_heartbeat(const wire::Heartbeat& heartbeat, std::vector<Incoming>& out) {
  if (!enter(heartbeat.header.incarnation)) return;
  if (!open_ && heartbeat.ack_incarnation != self_incarnation_) return;
  const std::uint64_t from = std::max<std::uint64_t>(heartbeat.events_from, 1);
  if (open_ && from > next_) {
    out.emplace_back(EventsLost{NodeNumber(heartbeat.header.origin), self_, next_, from - 1,
                                heartbeat.header.incarnation});
  }
  if (!open_ || from > next_) {
    next_ = from;
    buffer_.erase(buffer_.begin(), buffer_.lower_bound(from));
  }
  if (!open_) handled_ = from - 1;
  settled_ = from;
  open_ = true;
}

void IncomingEvents::deliver(ChannelKind kind, MissionTime now, std::vector<Incoming>& out) {
  if (!open_) return;
  for (auto first = buffer_.begin(); first != buffer_.end() && first->first == next_;
       first = buffer_.erase(first)) {
    ++next_;
    owes_ = true;
    if (!first->second) continue;
    const wire::SampleHeader& header = wire::header_of(*first->second);
    const NodeNumber origin(header.origin);
    if (header.expires >= now.count()) {
      out.emplace_back(Received{origin, kind, std::move(*first->second)});
    } else if (!places_kept(header.expires)) {
      out.emplace_back(EventExpired{wire::slot_of(*first->second), origin,
                                    NodeNumber(header.destination), header.sequence_number,
                                    header.incarnation});
    }
  }
}

void IncomingEvents::recall(const wire::SampleHeader& header) {
  if (!enter(header.incarnation)) return;
  open_ = true;
  handled_ = header.sequence_number;
  next_ = handled_ + 1;
}

void IncomingEvents::commit() { handled_ = next_ - 1; }

}  // namespace skein::blackboard
