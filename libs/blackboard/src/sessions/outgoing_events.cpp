// SPDX-License-Identifier: Apache-2.0
// The sending half of an event session with one peer.
#include "sessions/outgoing_events.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "sessions/tombstone.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/repeats.hpp"

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

std::vector<OutgoingEvents::Held>::iterator OutgoingEvents::find(std::uint64_t sequence) {
  const auto found = std::ranges::lower_bound(held_, sequence, {}, &Held::number);
  return found == held_.end() || found->number() != sequence ? held_.end() : found;
}

std::size_t OutgoingEvents::under_way() const {
  const auto end = std::ranges::lower_bound(held_, oldest() + kEventDepth, {}, &Held::number);
  return static_cast<std::size_t>(end - held_.begin());
}

void OutgoingEvents::give_up(std::uint64_t sequence) {
  const auto found = find(sequence);
  if (found == held_.end()) return;
  give_up(*found);
  settle_tombstones();
}

void OutgoingEvents::give_up(Held& event) {
  event.given_up = true;
  bury(event.sample);
}

void OutgoingEvents::settle_tombstones() {
  const auto first = std::ranges::find(held_, false, &Held::given_up);
  drop_first(static_cast<std::size_t>(first - held_.begin()));
  const auto joins = [](const Held& one, const Held& next) {
    return one.given_up && next.given_up && one.places + next.places <= kMostInARow;
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (i + 1 < held_.size() && joins(held_[i], held_[i + 1])) {
      held_[i + 1].places += held_[i].places;
      wire::header_of(held_[i + 1].sample).expires = tombstone_of(held_[i + 1].places);
      held_[i + 1].written.reset();  // with fewer places, if at all
      continue;
    }
    if (kept != i) held_[kept] = std::move(held_[i]);
    ++kept;
  }
  held_.resize(kept);
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
  const auto waiting = std::ranges::upper_bound(held_, sequence, {}, &Held::number);
  for (auto one = held_.begin(); one != waiting; ++one)
    if (one->receipt != 0 && !one->given_up) receipts.push_back(one->receipt);
  drop_first(static_cast<std::size_t>(waiting - held_.begin()));
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
  const auto one = find(wire::header_of(event).sequence_number);
  if (one == held_.end()) return;
  turn_of_old_ = one->writings == 0;
  write(*one, until);
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
    const auto at = held_[i].written ? again_at(i, round_trip) : Duration{};
    if (at) next = next ? std::min(*next, *at) : *at;
  }
  return next;
}

}  // namespace skein::blackboard
