// SPDX-License-Identifier: Apache-2.0
// The receiving half of what is too long to be said at once.
#include "sessions/incoming_parts.hpp"

#include "skein/blackboard/cdr.hpp"

namespace skein::blackboard {

/// What hides in parts is something that a node may say, and no part of anything.
bool IncomingParts::makes_sense(const wire::Part& part) const {
  const bool is_one_of_these = part.of_slot < wire::kSlotCount &&
                               wire::slot_class(static_cast<wire::Slot>(part.of_slot)) == of_;
  return is_one_of_these && part.total > 0 && part.total <= kLongest && !part.content.empty() &&
         part.offset < part.total && part.content.size() <= part.total - part.offset;
}

std::optional<std::variant<wire::Sample, Malformed>> IncomingParts::take(const wire::Part& part) {
  const std::uint64_t incarnation = part.header.incarnation;
  if (incarnation < incarnation_ || !makes_sense(part)) return std::nullopt;
  if (incarnation > incarnation_) {
    *this = IncomingParts(of_, quiet_);
    incarnation_ = incarnation;
  }
  if (part.number <= handled_ || part.number < number_) {
    owes_ = true;
    return std::nullopt;
  }
  if (part.number != number_ || part.total != total_) begin(part);
  const std::uint32_t before = there_;
  const bool comes_again = part.offset < there_ || later_.contains(part.offset);
  if (part.offset == there_) add(part.offset, part.content);
  add_later();
  if (part.offset > there_ && later_.size() < kMostLater)
    later_.insert_or_assign(part.offset, part.content);
  const bool names_gap = !later_.empty() && gap_told_ != there_;
  if (comes_again || names_gap || ++since_told_ > quiet_) owes_ = true;
  if (there_ == before || there_ < total_) return std::nullopt;
  auto event = decode(static_cast<wire::Slot>(part.of_slot), bytes_);
  std::vector<std::uint8_t>().swap(bytes_);
  return event;
}

void IncomingParts::begin(const wire::Part& part) {
  number_ = part.number;
  total_ = part.total;
  there_ = 0;
  bytes_.clear();
  later_.clear();
  gap_told_.reset();
}

void IncomingParts::told() {
  owes_ = false;
  since_told_ = 0;
  if (!later_.empty()) gap_told_ = there_;
}

// As much of it as is new: it may have been cut at other places than those before it.
void IncomingParts::add(std::uint32_t offset, const std::vector<std::uint8_t>& content) {
  const std::size_t known = there_ - offset;
  if (known >= content.size()) return;
  bytes_.insert(bytes_.end(), content.begin() + static_cast<std::ptrdiff_t>(known), content.end());
  there_ = offset + static_cast<std::uint32_t>(content.size());
}

void IncomingParts::add_later() {
  while (!later_.empty() && later_.begin()->first <= there_) {
    add(later_.begin()->first, later_.begin()->second);
    later_.erase(later_.begin());
  }
}

void IncomingParts::commit() {
  if (number_ == 0 || there_ < total_ || handled_ >= number_) return;
  handled_ = number_;
  owes_ = true;
}

void IncomingParts::recall(std::uint64_t incarnation, std::uint64_t number) {
  if (incarnation < incarnation_) return;
  *this = IncomingParts(of_, quiet_);
  incarnation_ = incarnation;
  number_ = handled_ = number;
}

// As long as it was not handled something of it is missing.
std::uint32_t IncomingParts::ack_bytes() const {
  if (handled_ >= number_) return kLongest;
  return there_ < total_ ? there_ : total_ - 1;
}

}  // namespace skein::blackboard
