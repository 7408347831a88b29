// SPDX-License-Identifier: Apache-2.0
// Finds frames in a stream of bytes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "skein/mavlink/frame.hpp"

namespace skein::mavlink {

/// What of a stream was no frame for us.
struct ParserCounts {
  std::uint64_t frames = 0;         ///< taken
  std::uint64_t skipped_bytes = 0;  ///< between frames: garbage, MAVLink 1, messages not known
  std::uint64_t bad_checksums = 0;  ///< of what began like a known message
  std::uint64_t unknown_flags = 0;  ///< frames that ask for what we do not understand
  bool operator==(const ParserCounts&) const = default;
};

/// Takes any bytes, in pieces of any size. After whatever turns out not to be a frame it looks on
/// from the very next byte, so nothing between two frames can make it miss the second; since what
/// begins like a frame is waited for to its end, a frame behind such a beginning may come up to 290
/// bytes later. A message that we do not know cannot be checked and counts as garbage.
///
/// Holds at most that many bytes. Cost: linear; with garbage that pretends to be frames, times a
/// frame's length. Signatures are taken along and not checked.
class Parser {
 public:
  /// The frames that end with these bytes.
  std::vector<Frame> take(std::span<const std::uint8_t> bytes);
  const ParserCounts& counts() const { return counts_; }

 private:
  enum class Found { kFrame, kNone, kTooShort };
  Found look_at(std::size_t start, Frame& frame, std::size_t& length);

  Bytes pending_;
  ParserCounts counts_;
};

}  // namespace skein::mavlink
