// SPDX-License-Identifier: Apache-2.0
#include "message_data.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "adapters/rtps/guid_text.hpp"

namespace skein::blackboard::passive {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kMessageHeader = 20, kSubmessageHeader = 4, kPrefixAt = 8, kPrefix = 12;
constexpr std::size_t kBeforeQos = 20;        ///< of DATA: flags, offset, reader, writer, sequence
constexpr std::size_t kBeforeQosOfPart = 32;  ///< of DATA_FRAG: fragments and sizes too
constexpr std::array<std::uint8_t, 4> kMagic{'R', 'T', 'P', 'S'};
constexpr std::uint8_t kPad = 0x01, kInfoTs = 0x09, kInfoSrc = 0x0c, kData = 0x15, kDataFrag = 0x16;
constexpr std::uint8_t kLittle = 0x01, kHasQos = 0x02, kHasData = 0x04, kInvalid = 0x02;
constexpr std::uint8_t kOfPartKey = 0x04;
constexpr std::uint8_t kBuiltin = 0xc0;  ///< in the last octet of an entity's number
constexpr std::uint16_t kSentinel = 1;   ///< the last of a list of parameters

}  // namespace

/// What holds for the submessages that follow.
struct MessageData::Context {
  std::string prefix;
  std::int64_t sent = 0;
};

/// Of one submessage.
struct MessageData::Body {
  std::uint8_t flags = 0;
  Bytes bytes;

  std::uint32_t number(std::size_t at, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8U | bytes[at + ((flags & kLittle) != 0 ? size - 1 - i : i)];
    return value;
  }
  std::uint64_t sequence() const { return std::uint64_t{number(12, 4)} << 32U | number(16, 4); }
  bool is_builtin() const { return (bytes[11] & kBuiltin) == kBuiltin; }
  std::string writer(const Context& context) const {
    return rtps::guid_text(context.prefix, bytes.subspan(8, 4));
  }
  /// What stands behind the QoS, which has its place where the header says.
  std::optional<Bytes> payload(std::size_t least) const {
    std::size_t at = 4 + number(2, 2);
    if (at < least) return std::nullopt;
    for (bool more = (flags & kHasQos) != 0; more;) {
      if (at + 4 > bytes.size()) return std::nullopt;
      more = number(at, 2) != kSentinel;
      at += more ? 4 + number(at + 2, 2) : 4;
    }
    if (at > bytes.size()) return std::nullopt;
    return bytes.subspan(at);
  }
  /// INFO_TS: seconds and a fraction of 2^32.
  std::int64_t instant() const {
    if ((flags & kInvalid) != 0 || bytes.size() < 8) return 0;
    constexpr std::int64_t kSecond = 1'000'000'000;
    const std::uint64_t fraction = std::uint64_t{number(4, 4)} * kSecond >> 32U;
    return std::int64_t{number(0, 4)} * kSecond + static_cast<std::int64_t>(fraction);
  }
};

bool MessageData::Given::add(std::uint64_t sequence) {
  if (sequence + kRemembered <= last) return false;
  if (sequence > last) {
    const std::uint64_t steps = std::min<std::uint64_t>(sequence - last, kRemembered);
    for (std::uint64_t i = 0; i < steps; ++i) recent.reset((sequence - i) % kRemembered);
    last = sequence;
  }
  if (recent.test(sequence % kRemembered)) return false;
  recent.set(sequence % kRemembered);
  return true;
}

void MessageData::give(SampleData sample) {
  if (given_[sample.writer].add(sample.sequence)) out_.push_back(std::move(sample));
}

void MessageData::take_whole(const Context& context, const Body& body) {
  if (body.bytes.size() < kBeforeQos || body.is_builtin()) return;
  const auto payload = body.payload(kBeforeQos);
  if (!payload) return;
  SampleData sample{body.writer(context), body.sequence(), context.sent, {}};
  if ((body.flags & kHasData) != 0) sample.bytes.assign(payload->begin(), payload->end());
  give(std::move(sample));
}

MessageData::Open* MessageData::opened(const Context& context, const Body& body, std::uint32_t size,
                                       std::uint32_t part) {
  Key key{body.writer(context), body.sequence()};
  if (const auto found = open_.find(key); found != open_.end()) {
    Open& known = found->second;
    return known.sample.bytes.size() == size && known.part == part ? &known : nullptr;
  }
  if (order_.size() == kMostOpen) {
    open_.erase(order_.front());
    order_.pop_front();
  }
  Open open{{key.first, key.second, context.sent, std::vector<std::uint8_t>(size)}, part, {}, 0};
  open.missing = (size + part - 1) / part;
  open.there.resize(open.missing);
  order_.push_back(key);
  return &open_.emplace(std::move(key), std::move(open)).first->second;
}

void MessageData::take_fragments(const Context& context, const Body& body) {
  if (body.bytes.size() < kBeforeQosOfPart || body.is_builtin()) return;
  const auto payload = body.payload(kBeforeQosOfPart);
  const std::uint32_t first = body.number(20, 4), part = body.number(26, 2),
                      size = body.number(28, 4);
  if (!payload || first == 0 || part == 0 || size == 0 || size > kLongest) return;
  if ((body.flags & kOfPartKey) != 0) return;
  Open* const open = opened(context, body, size, part);
  if (open == nullptr) return;
  std::size_t from = 0;
  for (std::uint32_t i = first - 1; i < first - 1 + body.number(24, 2); ++i) {
    const std::size_t at = std::size_t{i} * part;
    if (i >= open->there.size() || from >= payload->size()) break;
    const std::size_t length = std::min<std::size_t>({part, size - at, payload->size() - from});
    if (length < std::min<std::size_t>(part, size - at)) break;  // cut short
    std::copy_n(payload->begin() + static_cast<std::ptrdiff_t>(from), length,
                open->sample.bytes.begin() + static_cast<std::ptrdiff_t>(at));
    open->missing -= open->there[i] ? 0 : 1;
    open->there[i] = true;
    from += length;
  }
  if (open->missing > 0) return;
  const Key key{open->sample.writer, open->sample.sequence};
  give(std::move(open->sample));
  open_.erase(key);
  std::erase(order_, key);
}

std::vector<SampleData> MessageData::take(std::span<const std::uint8_t> message) {
  out_.clear();
  if (message.size() < kMessageHeader || !std::ranges::equal(message.first(4), kMagic)) return {};
  Context context{rtps::hexadecimal(message.subspan(kPrefixAt, kPrefix)), 0};
  for (Bytes rest = message.subspan(kMessageHeader); rest.size() >= kSubmessageHeader;) {
    const std::uint8_t kind = rest[0];
    const Body head{rest[1], rest};
    std::size_t length = head.number(2, 2);
    if (length == 0 && kind != kPad && kind != kInfoTs) length = rest.size() - kSubmessageHeader;
    if (length > rest.size() - kSubmessageHeader) break;
    const Body body{head.flags, rest.subspan(kSubmessageHeader, length)};
    if (kind == kInfoTs) context.sent = body.instant();
    if (kind == kInfoSrc && length >= kMessageHeader)
      context.prefix = rtps::hexadecimal(body.bytes.subspan(kPrefixAt, kPrefix));
    if (kind == kData) take_whole(context, body);
    if (kind == kDataFrag) take_fragments(context, body);
    rest = rest.subspan(kSubmessageHeader + length);
  }
  return std::exchange(out_, {});
}

}  // namespace skein::blackboard::passive
