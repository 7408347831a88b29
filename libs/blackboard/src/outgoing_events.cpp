// SPDX-License-Identifier: Apache-2.0
// The sending half of an event session with one peer.
#include "outgoing_events.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/repeats.hpp"
#include "tombstone.hpp"

namespace skein::blackboard {

namespace {

/// Leaves the event's place in the sequence, and nothing that it said: a narrow channel has better
/// to carry.
void bury(wire::Sample& event) {
  wire::SampleHeader header = std::move(wire::header_of(event));
  header.expires = tombstone_of(1);
  std::visit([](auto& sample) { sample = std::decay_t<decltype(sample)>(); }, event);
  wire::header_of(event) = std::move(header);
}

}  // namespace

void OutgoingEvents::hold(wire::Sample event, std::uint64_t receipt) {
  SKEIN_EXPECTS(!full());
  recall(std::move(event), receipt);
  held_.back().may_have_arrived = false;
}

void OutgoingEvents::recall(wire::Sample event, std::uint64_t receipt) {
  SKEIN_EXPECTS(wire::header_of(event).sequence_number == next_);
  held_.push_back({std::move(event)});
  held_.back().receipt = receipt;
  held_.back().may_have_arrived = true;  // as far as is known
  ++next_;
}

void OutgoingEvents::give_up(std::uint64_t sequence) {
  if (sequence < oldest() || sequence >= next_) return;
  give_up(held_[sequence - oldest()]);
  settle_tombstones();
}

void OutgoingEvents::give_up(Held& event) {
  event.given_up = true;
  bury(event.sample);
}

void OutgoingEvents::settle_tombstones() {
  const auto first = std::ranges::find(held_, false, &Held::given_up);
  drop_first(static_cast<std::size_t>(first - held_.begin()));
  std::uint64_t places = 0;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    places = held_[i].given_up ? std::min(places + 1, kMostPlaces) : 0;
    if (places == 0 || is_told_by_next(i)) continue;
    std::int64_t& expires = wire::header_of(held_[i].sample).expires;
    if (expires == tombstone_of(places)) continue;
    expires = tombstone_of(places);
    held_[i].written.reset();  // with fewer places, if at all
  }
}

bool OutgoingEvents::is_told_by_next(std::size_t index) const {
  return held_[index].given_up && index + 1 < under_way() && held_[index + 1].given_up;
}

void OutgoingEvents::drop_first(std::size_t count) {
  if (count == 0) return;
  if (count == held_.size()) return void(std::exchange(held_, {}));
  held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(count));
}

std::vector<std::uint64_t> OutgoingEvents::acknowledge(std::uint64_t sequence) {
  std::vector<std::uint64_t> receipts;
  if (sequence >= next_) return receipts;
  if (sequence < oldest()) return receipts;
  const std::size_t handled = sequence - oldest() + 1;
  for (std::size_t i = 0; i < handled; ++i)
    if (held_[i].receipt != 0 && !held_[i].given_up) receipts.push_back(held_[i].receipt);
  drop_first(handled);
  settle_tombstones();
  for (Held& event : held_) event.writings = std::min(event.writings, 1);
  return receipts;
}

void OutgoingEvents::resend() {
  for (Held& event : held_) {
    event.written.reset();
    event.writings = 0;
  }
}

void OutgoingEvents::become(std::uint64_t incarnation) {
  for (Held& event : held_) wire::header_of(event.sample).incarnation = incarnation;
  resend();
}

std::vector<EventExpired> OutgoingEvents::expire(MissionTime now) {
  std::vector<EventExpired> expired;
  for (Held& event : held_) {
    const wire::SampleHeader& header = wire::header_of(event.sample);
    if (event.given_up || header.expires >= now.count()) continue;
    expired.push_back({wire::slot_of(event.sample), NodeNumber(header.origin),
                       NodeNumber(header.destination), header.sequence_number, header.incarnation,
                       event.receipt, event.may_have_arrived});
    give_up(event);
  }
  if (!expired.empty()) settle_tombstones();
  return expired;
}

void OutgoingEvents::write(Held& event, Duration at) {
  event.written = at;
  event.may_have_arrived = event.may_have_arrived || contact_;
  ++event.writings;
}

std::optional<Duration> OutgoingEvents::again_at(std::size_t index, Duration round_trip) const {
  if (index >= kAgainAtOnce) return std::nullopt;
  const Held& event = held_[index];
  const Duration first = retransmission_ + round_trip;
  const Duration most = Duration::nanoseconds(first.count() * kMostBackOff);
  return *event.written + doubled(first, event.writings - 1, most);
}

bool OutgoingEvents::is_due(std::size_t index, Now now, Duration round_trip) const {
  if (is_told_by_next(index)) return false;
  const Held& event = held_[index];
  if (event.written) {
    const auto again = again_at(index, round_trip);
    if (!again || *again > now.steady) return false;
  }
  return event.given_up || wire::header_of(event.sample).expires >= now.mission.count();
}

std::vector<const wire::Sample*> OutgoingEvents::take_due(Now now, Duration round_trip) {
  std::vector<const wire::Sample*> due;
  for (std::size_t i = 0; i < under_way(); ++i) {
    if (!is_due(i, now, round_trip)) continue;
    write(held_[i], now.steady);
    due.push_back(&held_[i].sample);
  }
  return due;
}

const wire::Sample* OutgoingEvents::first_due(Now now, Duration round_trip) const {
  const wire::Sample* old = nullptr;
  const wire::Sample* fresh = nullptr;
  for (std::size_t i = 0; i < under_way() && (fresh == nullptr || old == nullptr); ++i) {
    const wire::Sample*& kind = held_[i].writings > 0 ? old : fresh;
    if (kind == nullptr && is_due(i, now, round_trip)) kind = &held_[i].sample;
  }
  if (old == nullptr || fresh == nullptr) return old != nullptr ? old : fresh;
  return turn_of_old_ ? old : fresh;
}

void OutgoingEvents::written(const wire::Sample& event, Duration until) {
  const std::uint64_t sequence = wire::header_of(event).sequence_number;
  if (sequence < oldest() || sequence >= next_) return;
  Held& one = held_[sequence - oldest()];
  turn_of_old_ = one.writings == 0;
  write(one, until);
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
    if (is_told_by_next(i)) continue;
    const auto at = held_[i].written ? again_at(i, round_trip) : Duration{};
    if (at) next = next ? std::min(*next, *at) : *at;
  }
  return next;
}

}  // namespace skein::blackboard
