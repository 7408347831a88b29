// SPDX-License-Identifier: Apache-2.0
// The sending half of an event session with one peer.
#include "outgoing_events.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::blackboard {

namespace {

/// Expired before any time.
constexpr std::int64_t kLongAgo = std::numeric_limits<std::int64_t>::min();

}  // namespace

void OutgoingEvents::hold(wire::Sample event) {
  SKEIN_EXPECTS(!full());
  recall(std::move(event));
}

void OutgoingEvents::recall(wire::Sample event) {
  SKEIN_EXPECTS(wire::header_of(event).sequence_number == next_);
  held_.push_back({std::move(event), std::nullopt, false});
  ++next_;
}

void OutgoingEvents::give_up(std::uint64_t sequence) {
  if (sequence < oldest() || sequence >= next_) return;
  Held& event = held_[sequence - oldest()];
  event.given_up = true;
  wire::header_of(event.sample).expires = kLongAgo;
  drop_given_up();
}

void OutgoingEvents::drop_given_up() {
  while (!held_.empty() && held_.front().given_up) held_.pop_front();
}

void OutgoingEvents::acknowledge(std::uint64_t sequence) {
  if (sequence >= next_) return;
  while (!held_.empty() && oldest() <= sequence) held_.pop_front();
}

void OutgoingEvents::resend() {
  for (Held& event : held_) event.written.reset();
}

std::vector<EventExpired> OutgoingEvents::expire(MissionTime now) {
  std::vector<EventExpired> expired;
  for (Held& event : held_) {
    wire::SampleHeader& header = wire::header_of(event.sample);
    if (event.given_up || header.expires >= now.count()) continue;
    event.given_up = true;
    header.expires = kLongAgo;
    expired.push_back({wire::slot_of(event.sample), NodeNumber(header.origin),
                       NodeNumber(header.destination), header.sequence_number, header.incarnation});
  }
  drop_given_up();
  return expired;
}

std::vector<const wire::Sample*> OutgoingEvents::take_due(Now now, Duration round_trip) {
  std::vector<const wire::Sample*> due;
  for (std::size_t i = 0; i < under_way(); ++i) {
    Held& event = held_[i];
    if (event.written && *event.written + retransmission_ + round_trip > now.steady) continue;
    if (!event.given_up && wire::header_of(event.sample).expires < now.mission.count()) continue;
    event.written = now.steady;
    due.push_back(&event.sample);
  }
  return due;
}

std::optional<MissionTime> OutgoingEvents::first_expiry() const {
  std::int64_t first = wire::kNever;
  for (const Held& event : held_)
    if (!event.given_up) first = std::min(first, wire::header_of(event.sample).expires);
  if (first == wire::kNever) return std::nullopt;
  return MissionTime() + Duration::nanoseconds(first);
}

std::optional<Duration> OutgoingEvents::next_due(Duration round_trip) const {
  std::optional<Duration> next;
  for (std::size_t i = 0; i < under_way(); ++i) {
    const Held& event = held_[i];
    const Duration at = event.written ? *event.written + retransmission_ + round_trip : Duration{};
    next = next ? std::min(*next, at) : at;
  }
  return next;
}

}  // namespace skein::blackboard
