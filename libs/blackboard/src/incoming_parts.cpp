// SPDX-License-Identifier: Apache-2.0
// The receiving half of what is too long to be said at once.
#include "incoming_parts.hpp"

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
  const bool is_over = part.number <= handled_ || part.number < number_;
  const bool begins = part.number != number_ || part.total != total_;
  const bool follows = !is_over && part.offset == (begins ? 0 : there_);
  if (!follows || ++since_told_ > quiet_) owes_ = true;
  if (is_over) return std::nullopt;
  if (begins) {
    number_ = part.number;
    total_ = part.total;
    there_ = 0;
    bytes_.clear();
  }
  if (!follows) return std::nullopt;
  bytes_.insert(bytes_.end(), part.content.begin(), part.content.end());
  there_ += static_cast<std::uint32_t>(part.content.size());
  if (there_ < total_) return std::nullopt;
  auto event = decode(static_cast<wire::Slot>(part.of_slot), bytes_);
  std::vector<std::uint8_t>().swap(bytes_);
  return event;
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
