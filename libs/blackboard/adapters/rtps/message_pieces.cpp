// SPDX-License-Identifier: Apache-2.0
#include "message_pieces.hpp"

#include <optional>

#include "submessages.hpp"

namespace skein::blackboard::rtps {
namespace {

/// One of a kind that says what holds for others, which nobody here sends.
bool is_odd(SubmessageKind kind) {
  return kind == SubmessageKind::kInfoSrc || kind == SubmessageKind::kInfoReply ||
         kind == SubmessageKind::kInfoReplyIp4 || kind == SubmessageKind::kSrtpsPrefix;
}

/// What goes together: a submessage, or several from SEC_PREFIX to SEC_POSTFIX.
std::optional<Bytes> unit_of(Bytes rest) {
  std::size_t length = 0;
  for (bool is_open = true; is_open;) {
    const auto one = first_submessage(rest.subspan(length));
    if (!one || is_odd(one->kind)) return std::nullopt;
    const bool begins = length == 0 && one->kind == SubmessageKind::kSecPrefix;
    is_open = begins || (length > 0 && one->kind != SubmessageKind::kSecPostfix);
    length += one->whole.size();
  }
  return rest.first(length);
}

/// Puts units together into messages.
class Cutter {
 public:
  Cutter(Bytes header, std::size_t longest) : header_(header), longest_(longest) { begin(); }

  /// What holds for all units that follow, until there is another.
  void hold(Bytes info) {
    (SubmessageKind(info[0]) == SubmessageKind::kInfoDst ? destination_ : time_) = {info, false};
  }
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
  if (message.size() <= longest || !is_message(message)) return {};
  Cutter cutter(message.first(kMessageHeader), longest);
  for (Bytes rest = message.subspan(kMessageHeader); !rest.empty();) {
    const auto unit = unit_of(rest);
    if (!unit) return {};
    const auto kind = SubmessageKind((*unit)[0]);
    if (kind == SubmessageKind::kInfoDst || kind == SubmessageKind::kInfoTs) {
      cutter.hold(*unit);
    } else {
      cutter.put(*unit);
    }
    rest = rest.subspan(unit->size());
  }
  auto pieces = cutter.take();
  const bool is_no_use = pieces.size() == 1 && pieces[0].size() > longest;
  const bool is_empty = pieces[0].size() == kMessageHeader;
  return is_no_use || is_empty ? std::vector<std::vector<std::uint8_t>>{} : pieces;
}

}  // namespace skein::blackboard::rtps
