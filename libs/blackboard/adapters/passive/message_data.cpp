// SPDX-License-Identifier: Apache-2.0
#include "message_data.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "adapters/rtps/guid_text.hpp"
#include "adapters/rtps/submessages.hpp"

namespace skein::blackboard::passive {
namespace {

using rtps::Bytes;
using rtps::SubmessageKind;

constexpr std::size_t kPrefixAt = 8, kPrefix = 12;
constexpr std::size_t kBeforeQos = 20;        ///< of DATA: flags, offset, reader, writer, sequence
constexpr std::size_t kBeforeQosOfPart = 32;  ///< of DATA_FRAG: fragments and sizes too
constexpr std::uint8_t kInvalid = 0x02, kOfPartKey = 0x04;
constexpr std::uint8_t kBuiltin = 0xc0;  ///< in the last octet of an entity's number
constexpr std::uint16_t kSentinel = 1;   ///< the last of a list of parameters

}  // namespace

/// What holds for the submessages that follow.
struct MessageData::Context {
  std::string prefix;
  std::int64_t sent = 0;
};

/// Of one submessage.
struct MessageData::Body : rtps::Submessage {
  std::size_t size() const { return body.size(); }
  std::uint64_t sequence() const { return std::uint64_t{number(12, 4)} << 32U | number(16, 4); }
  bool is_builtin() const { return (body[11] & kBuiltin) == kBuiltin; }
  std::string writer(const Context& context) const {
    return rtps::guid_text(context.prefix, body.subspan(8, 4));
  }
  /// What stands behind the QoS, which has its place where the header says.
  std::optional<Bytes> payload(std::size_t least) const {
    std::size_t at = 4 + number(2, 2);
    if (at < least) return std::nullopt;
    for (bool more = (flags & rtps::kHasQos) != 0; more;) {
      if (at + 4 > size()) return std::nullopt;
      more = number(at, 2) != kSentinel;
      at += more ? 4 + number(at + 2, 2) : 4;
    }
    if (at > size()) return std::nullopt;
    return body.subspan(at);
  }
  /// INFO_TS: seconds and a fraction of 2^32.
  std::int64_t instant() const {
    if ((flags & kInvalid) != 0 || size() < 8) return 0;
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
  if (body.size() < kBeforeQos || body.is_builtin()) return;
  const auto payload = body.payload(kBeforeQos);
  if (!payload) return;
  SampleData sample{body.writer(context), body.sequence(), context.sent, {}};
  if ((body.flags & rtps::kHasData) != 0) sample.bytes.assign(payload->begin(), payload->end());
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
  if (body.size() < kBeforeQosOfPart || body.is_builtin()) return;
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
  if (!rtps::is_message(message)) return {};
  Context context{rtps::hexadecimal(message.subspan(kPrefixAt, kPrefix)), 0};
  for (Bytes rest = message.subspan(rtps::kMessageHeader); !rest.empty();) {
    const auto one = rtps::first_submessage(rest);
    if (!one) break;
    const Body body{*one};
    if (one->kind == SubmessageKind::kInfoTs) context.sent = body.instant();
    if (one->kind == SubmessageKind::kInfoSrc && body.size() >= kPrefixAt + kPrefix)
      context.prefix = rtps::hexadecimal(one->body.subspan(kPrefixAt, kPrefix));
    if (one->kind == SubmessageKind::kData) take_whole(context, body);
    if (one->kind == SubmessageKind::kDataFrag) take_fragments(context, body);
    rest = rest.subspan(one->whole.size());
  }
  return std::exchange(out_, {});
}

}  // namespace skein::blackboard::passive
