// SPDX-License-Identifier: Apache-2.0
#include "submessages.hpp"

#include <algorithm>
#include <array>

namespace skein::blackboard::rtps {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic{'R', 'T', 'P', 'S'};

}  // namespace

std::uint32_t Submessage::number(std::size_t at, std::size_t size) const {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8U | body[at + ((flags & kLittle) != 0 ? size - 1 - i : i)];
  return value;
}

bool is_message(Bytes message) {
  return message.size() >= kMessageHeader &&
         std::ranges::equal(message.first(kMagic.size()), kMagic);
}

std::optional<Submessage> first_submessage(Bytes rest) {
  if (rest.size() < kSubmessageHeader) return std::nullopt;
  Submessage one{SubmessageKind(rest[0]), rest[1], rest, rest.subspan(2)};
  std::size_t length = kSubmessageHeader + one.number(0, 2);
  const bool may_be_empty = one.kind == SubmessageKind::kPad || one.kind == SubmessageKind::kInfoTs;
  if (length == kSubmessageHeader && !may_be_empty) length = rest.size();
  if (length > rest.size()) return std::nullopt;
  one.whole = rest.first(length);
  one.body = one.whole.subspan(kSubmessageHeader);
  return one;
}

}  // namespace skein::blackboard::rtps
