// SPDX-License-Identifier: Apache-2.0
// The sending half of what is too long to be said at once.
#include "sessions/outgoing_parts.hpp"

#include <algorithm>
#include <variant>

#include "skein/blackboard/cdr.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {

void OutgoingParts::hold(const wire::Sample& sample, std::uint64_t receipt) {
  const wire::SampleHeader& header = wire::header_of(sample);
  const wire::Slot slot = wire::slot_of(sample);
  SKEIN_EXPECTS(wire::slot_class(slot) != wire::SlotClass::kEvent ||
                header.sequence_number == next_);
  Held& held = held_.emplace_back();
  held.number = next_++;
  held.slot = slot;
  held.header = header;
  held.receipt = receipt;
  held.bytes = in_cdr(sample);
  bytes_ += held.bytes.size();
}

void OutgoingParts::drop(std::vector<Held>::iterator one) {
  bytes_ -= one->bytes.size();
  held_.erase(one);
  if (held_.empty()) held_ = {};
}

void OutgoingParts::drop_front() {
  drop(held_.begin());
  acked_ = 0;
  begin_at(0);
}

void OutgoingParts::begin_at(std::uint32_t byte) {
  next_byte_ = last_offset_ = byte;
  gap_.reset();
  fill_ = false;
}

void OutgoingParts::give_up(std::uint64_t number) {
  const auto found = std::ranges::find(held_, number, &Held::number);
  if (found == held_.end()) return;
  if (found == held_.begin()) return drop_front();
  drop(found);
}

// Parts that were under way behind a gap each name it: it is filled once.
std::vector<std::uint64_t> OutgoingParts::heard(std::uint64_t number, std::uint32_t bytes,
                                                bool lacks) {
  std::vector<std::uint64_t> receipts;
  const auto has = [&](const Held& one) {
    return one.number < number || (one.number == number && bytes >= one.bytes.size());
  };
  while (number < next_ && !held_.empty() && has(held_.front())) {
    if (held_.front().receipt != 0) receipts.push_back(held_.front().receipt);
    drop_front();
  }
  if (held_.empty() || held_.front().number != number) return receipts;
  const bool restarted = bytes < acked_;
  acked_ = bytes;
  if (restarted || next_byte_ < bytes) begin_at(bytes);
  if (!lacks) {
    gap_.reset();
  } else if (gap_ != bytes) {
    gap_ = bytes;
    fill_ = bytes < next_byte_;
  }
  return receipts;
}

void OutgoingParts::recall_acknowledged(std::uint64_t number) {
  while (!held_.empty() && held_.front().number <= number) drop_front();
}

std::uint64_t OutgoingParts::settled() const {
  return (held_.empty() ? next_ : held_.front().number) - 1;
}

void OutgoingParts::become(std::uint64_t incarnation) {
  for (Held& one : held_) {
    one.header.incarnation = incarnation;
    auto again = decode(one.slot, one.bytes);
    auto& sample = std::get<wire::Sample>(again);
    wire::header_of(sample).incarnation = incarnation;
    one.bytes = in_cdr(sample);
  }
  acked_ = 0;
  begin_at(0);
}

std::vector<EventExpired> OutgoingParts::expire(MissionTime now) {
  std::vector<EventExpired> expired;
  for (std::size_t i = held_.size(); i-- > 0;) {
    const Held& one = held_[i];
    if (one.header.expires >= now.count()) continue;
    expired.push_back({one.slot, NodeNumber(one.header.origin), NodeNumber(one.header.destination),
                       one.header.sequence_number, one.header.incarnation, one.receipt,
                       one.may_have_arrived});
    give_up(one.number);
  }
  std::ranges::reverse(expired);
  return expired;
}

bool OutgoingParts::window_is_open(std::uint32_t most_bytes) const {
  return !held_.empty() && next_byte_ < held_.front().bytes.size() &&
         next_byte_ < acked_ + std::uint64_t{kPartsUnderWay} * most_bytes;
}

std::uint32_t OutgoingParts::next_offset(std::uint32_t most_bytes) const {
  if (fill_) return *gap_;
  if (window_is_open(most_bytes)) return next_byte_;
  return gap_ ? acked_ : std::max(last_offset_, acked_);
}

std::optional<wire::Part> OutgoingParts::next(Duration now, std::uint32_t most_bytes,
                                              Duration time_out) const {
  const auto due = next_due(most_bytes, time_out);
  if (!due || *due > now) return std::nullopt;
  const Held& front = held_.front();
  wire::Part part;
  part.number = front.number;
  part.of_slot = static_cast<std::uint8_t>(front.slot);
  part.total = static_cast<std::uint32_t>(front.bytes.size());
  part.offset = next_offset(most_bytes);
  const std::size_t count = std::min<std::size_t>(most_bytes, front.bytes.size() - part.offset);
  const auto from = front.bytes.begin() + part.offset;
  part.content.assign(from, from + static_cast<std::ptrdiff_t>(count));
  return part;
}

void OutgoingParts::written(const wire::Part& part, Duration until) {
  if (held_.empty() || held_.front().number != part.number) return;
  last_written_ = until;
  fill_ = false;
  if (part.offset < next_byte_) return;
  last_offset_ = part.offset;
  next_byte_ = part.offset + static_cast<std::uint32_t>(part.content.size());
  if (next_byte_ == part.total && contact_) held_.front().may_have_arrived = true;
}

std::optional<MissionTime> OutgoingParts::first_expiry() const {
  std::int64_t first = wire::kNever;
  for (const Held& one : held_) first = std::min(first, one.header.expires);
  if (first == wire::kNever) return std::nullopt;
  return MissionTime::nanoseconds(first);
}

std::optional<Duration> OutgoingParts::next_due(std::uint32_t most_bytes, Duration time_out) const {
  if (held_.empty()) return std::nullopt;
  if (fill_ || window_is_open(most_bytes)) return Duration{};
  return last_written_ + time_out;
}

}  // namespace skein::blackboard
