// SPDX-License-Identifier: Apache-2.0
#include "departures.hpp"

#include <algorithm>
#include <array>

#include "submessages.hpp"

namespace skein::blackboard::rtps {
namespace {

/// Of DATA, behind its header: flags, offset of the QoS, reader, writer, sequence number.
constexpr std::size_t kOffsetAt = 2, kWriterAt = 8, kBeforeQos = 20;
constexpr std::array<std::uint8_t, 4> kAnnouncer{0x00, 0x01, 0x00, 0xc2};
constexpr std::uint32_t kSentinel = 0x01, kStatusInfo = 0x71;
constexpr std::uint8_t kDisposed = 0x01, kUnregistered = 0x02;

/// By the QoS of the sample: parameters, each behind its number and length.
bool is_gone(const Submessage& data) {
  std::size_t at = 4 + data.number(kOffsetAt, 2);
  while (at + 4 <= data.body.size()) {
    const std::uint32_t parameter = data.number(at, 2), length = data.number(at + 2, 2);
    at += 4;
    if (parameter == kSentinel || at + length > data.body.size()) return false;
    // Most significant octet first, whatever the order of the rest.
    if (parameter == kStatusInfo && length >= 4)
      return (data.body[at + 3] & (kDisposed | kUnregistered)) != 0;
    at += length;
  }
  return false;
}

}  // namespace

bool tells_departure(std::span<const std::uint8_t> message) {
  if (!is_message(message)) return false;
  for (Bytes rest = message.subspan(kMessageHeader); !rest.empty();) {
    const auto one = first_submessage(rest);
    if (!one) return false;
    rest = rest.subspan(one->whole.size());
    if (one->kind != SubmessageKind::kData || one->body.size() < kBeforeQos) continue;
    if (!std::ranges::equal(one->body.subspan(kWriterAt, kAnnouncer.size()), kAnnouncer)) continue;
    if ((one->flags & kHasData) == 0) return true;
    if ((one->flags & kHasQos) != 0 && is_gone(*one)) return true;
  }
  return false;
}

}  // namespace skein::blackboard::rtps
