// SPDX-License-Identifier: Apache-2.0
#include "message_pieces.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace skein::blackboard::rtps {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeader = 20, kSubmessageHeader = 4;
constexpr std::array<std::uint8_t, 4> kMagic{'R', 'T', 'P', 'S'};
constexpr std::uint8_t kPad = 0x01, kInfoTs = 0x09, kInfoSrc = 0x0c, kInfoReplyIp4 = 0x0d,
                       kInfoDst = 0x0e, kInfoReply = 0x0f, kSecPrefix = 0x31, kSecPostfix = 0x32,
                       kSrtpsPrefix = 0x33;

/// The first submessage of what is left of a message; none: it is cut short. Of length 0 means to
/// the end, but for those that may be empty.
std::optional<Bytes> first_of(Bytes rest) {
  if (rest.size() < kSubmessageHeader) return std::nullopt;
  const bool is_little = (rest[1] & 1U) != 0;
  const std::size_t low = rest[is_little ? 2 : 3], high = rest[is_little ? 3 : 2];
  std::size_t length = kSubmessageHeader + (high << 8U | low);
  const bool may_be_empty = rest[0] == kPad || rest[0] == kInfoTs;
  if (length == kSubmessageHeader && !may_be_empty) length = rest.size();
  if (length > rest.size()) return std::nullopt;
  return rest.first(length);
}

/// One of a kind that says what holds for others, which nobody here sends.
bool is_odd(std::uint8_t kind) {
  return kind == kInfoSrc || kind == kInfoReply || kind == kInfoReplyIp4 || kind == kSrtpsPrefix;
}

/// What goes together: a submessage, or several from SEC_PREFIX to SEC_POSTFIX.
std::optional<Bytes> unit_of(Bytes rest) {
  std::size_t length = 0;
  for (bool is_open = true; is_open;) {
    const auto one = first_of(rest.subspan(length));
    if (!one || is_odd((*one)[0])) return std::nullopt;
    const bool begins = length == 0 && (*one)[0] == kSecPrefix;
    is_open = begins || (length > 0 && (*one)[0] != kSecPostfix);
    length += one->size();
  }
  return rest.first(length);
}

/// Puts units together into messages.
class Cutter {
 public:
  Cutter(Bytes header, std::size_t longest) : header_(header), longest_(longest) { begin(); }

  /// What holds for all units that follow, until there is another.
  void hold(Bytes info) { (info[0] == kInfoDst ? destination_ : time_) = {info, false}; }
  void put(Bytes unit) {
    if (has_unit_ && pieces_.back().size() + unsaid() + unit.size() > longest_) begin();
    for (Info* info : {&destination_, &time_}) {
      if (!info->is_said) append(info->bytes);
      info->is_said = true;
    }
    append(unit);
    has_unit_ = true;
  }
  std::vector<std::vector<std::uint8_t>> take() { return std::move(pieces_); }

 private:
  struct Info {
    Bytes bytes;
    bool is_said = false;
  };
  void begin() {
    pieces_.emplace_back(header_.begin(), header_.end());
    destination_.is_said = time_.is_said = has_unit_ = false;
  }
  std::size_t unsaid() const {
    return (destination_.is_said ? 0 : destination_.bytes.size()) +
           (time_.is_said ? 0 : time_.bytes.size());
  }
  void append(Bytes bytes) {
    pieces_.back().insert(pieces_.back().end(), bytes.begin(), bytes.end());
  }

  Bytes header_;
  std::size_t longest_;
  Info destination_, time_;
  bool has_unit_ = false;
  std::vector<std::vector<std::uint8_t>> pieces_;
};

}  // namespace

std::vector<std::vector<std::uint8_t>> pieces_of(Bytes message, std::size_t longest) {
  if (message.size() <= longest || message.size() < kHeader) return {};
  if (!std::ranges::equal(message.first(kMagic.size()), kMagic)) return {};
  Cutter cutter(message.first(kHeader), longest);
  for (Bytes rest = message.subspan(kHeader); !rest.empty();) {
    const auto unit = unit_of(rest);
    if (!unit) return {};
    const std::uint8_t kind = (*unit)[0];
    if (kind == kInfoDst || kind == kInfoTs) {
      cutter.hold(*unit);
    } else {
      cutter.put(*unit);
    }
    rest = rest.subspan(unit->size());
  }
  auto pieces = cutter.take();
  const bool is_no_use = pieces.size() == 1 && pieces[0].size() > longest;
  const bool is_empty = pieces[0].size() == kHeader;
  return is_no_use || is_empty ? std::vector<std::vector<std::uint8_t>>{} : pieces;
}

}  // namespace skein::blackboard::rtps
