// SPDX-License-Identifier: Apache-2.0
// Frames of MAVLink 2, and messages in them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/mavlink/messages.hpp"

namespace skein::mavlink {

using Bytes = std::vector<std::uint8_t>;

/// Who speaks: vehicles from 1, stations from 255 down; components of one system.
struct Address {
  std::uint8_t system = 0;
  std::uint8_t component = 0;
  bool operator==(const Address&) const = default;
};

/// First byte of a frame of MAVLink 2.
inline constexpr std::uint8_t kMagic = 0xfd;
inline constexpr std::size_t kHeaderSize = 10;
inline constexpr std::size_t kChecksumSize = 2;
inline constexpr std::size_t kSignatureSize = 13;
/// Of the flags that a receiver must understand: a signature follows.
inline constexpr std::uint8_t kSignedFlag = 0x01;

/// What is between the checksums, apart from the signature.
struct Frame {
  Address from;
  std::uint8_t sequence = 0;  ///< of all that `from` sends
  std::uint32_t message = 0;  ///< id of its type, 24 bits
  bool is_signed = false;     ///< the signature is not checked
  Bytes payload = {};         ///< zeros at its end may have been cut
  bool operator==(const Frame&) const = default;
};

/// Of a message type that we know.
struct Known {
  std::uint32_t message = 0;
  Layout layout;
};
/// Null when we do not know it.
const Known* find_known(std::uint32_t message);

/// The bytes of an unsigned frame. Precondition: its message is known.
Bytes to_bytes(const Frame& frame);

/// The message with zeros at its end cut, never the first byte.
Frame to_frame(const Message& message, Address from, std::uint8_t sequence);
/// What was cut or not sent by an older sender is zero; what an unknown newer one appended is left
/// out. Absent when the type is not known.
std::optional<Message> to_message(const Frame& frame);

/// The words of a STATUSTEXT; what is not printable ASCII is a question mark.
std::string text_of(const StatusText& status);

}  // namespace skein::mavlink
