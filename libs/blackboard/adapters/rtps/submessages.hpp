// SPDX-License-Identifier: Apache-2.0
// The submessages of an RTPS message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace skein::blackboard::rtps {

using Bytes = std::span<const std::uint8_t>;

inline constexpr std::size_t kMessageHeader = 20, kSubmessageHeader = 4;
inline constexpr std::uint8_t kLittle = 0x01;   ///< flag of all submessages: its order of bytes
inline constexpr std::uint8_t kHasQos = 0x02;   ///< flag of DATA
inline constexpr std::uint8_t kHasData = 0x04;  ///< flag of DATA; without it a key or nothing

enum class SubmessageKind : std::uint8_t {
  kPad = 0x01,
  kInfoTs = 0x09,
  kInfoSrc = 0x0c,
  kInfoReplyIp4 = 0x0d,
  kInfoDst = 0x0e,
  kInfoReply = 0x0f,
  kData = 0x15,
  kDataFrag = 0x16,
  kSecPrefix = 0x31,
  kSecPostfix = 0x32,
  kSrtpsPrefix = 0x33
};

/// One of them; a view into the message.
struct Submessage {
  SubmessageKind kind = SubmessageKind::kPad;  ///< may be one that has no name here
  std::uint8_t flags = 0;
  Bytes whole;  ///< with its header
  Bytes body;

  /// The unsigned number at a place of the body, of 1 to 4 octets. Requires that they are there.
  std::uint32_t number(std::size_t at, std::size_t size) const;
};

/// Whether it begins as a message of RTPS does. Source: RTPS 2.3, 8.3.3.1.
bool is_message(Bytes message);

/// The first submessage of what is left of a message behind its header; none: it is cut short.
/// Length 0 means to the end, but for those that may be empty. Source: RTPS 2.3, 9.4.5.1.
std::optional<Submessage> first_submessage(Bytes rest);

}  // namespace skein::blackboard::rtps
