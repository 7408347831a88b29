// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink/parser.hpp"

#include <algorithm>

namespace skein::mavlink {

std::vector<Frame> Parser::take(std::span<const std::uint8_t> bytes) {
  pending_.insert(pending_.end(), bytes.begin(), bytes.end());
  std::vector<Frame> frames;
  std::size_t at = 0;
  while (at < pending_.size()) {
    Frame frame;
    std::size_t length = 0;
    const Found found = look_at(at, frame, length);
    if (found == Found::kTooShort) break;
    if (found == Found::kFrame) {
      frames.push_back(std::move(frame));
      ++counts_.frames;
      at += length;
    } else {
      ++counts_.skipped_bytes;
      ++at;
    }
  }
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(at));
  return frames;
}

Parser::Found Parser::look_at(std::size_t start, Frame& frame, std::size_t& length) {
  const std::uint8_t* const head = pending_.data() + start;
  const std::size_t left = pending_.size() - start;
  if (head[0] != kMagic) return Found::kNone;
  if (left < kHeaderSize) return Found::kTooShort;
  frame.message = head[7] | (static_cast<std::uint32_t>(head[8]) << 8U) |
                  (static_cast<std::uint32_t>(head[9]) << 16U);
  const Known* known = find_known(frame.message);
  if (known == nullptr) return Found::kNone;
  const std::size_t size = head[1];
  const std::size_t checked = kHeaderSize + size;
  frame.is_signed = (head[2] & kSignedFlag) != 0;
  length = checked + kChecksumSize + (frame.is_signed ? kSignatureSize : 0);
  if (left < length) return Found::kTooShort;
  Checksum crc;
  std::for_each(head + 1, head + checked, [&](std::uint8_t byte) { crc.add(byte); });
  crc.add(known->layout.crc_extra);
  if (head[checked] != (crc.value() & 0xffU) || head[checked + 1] != (crc.value() >> 8U)) {
    ++counts_.bad_checksums;
    return Found::kNone;
  }
  if ((head[2] & ~kSignedFlag) != 0) {
    ++counts_.unknown_flags;
    return Found::kNone;
  }
  frame.sequence = head[4];
  frame.from = {head[5], head[6]};
  frame.payload.assign(head + kHeaderSize, head + checked);
  return Found::kFrame;
}

}  // namespace skein::mavlink
