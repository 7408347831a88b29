// SPDX-License-Identifier: Apache-2.0
// GUIDs of RTPS as Endpoint::guid writes them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace skein::blackboard::rtps {

/// Two digits a byte, in lower case.
inline std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

/// Of an entity of the participant with that prefix: "0123456789abcdef01234567.000001c2".
inline std::string guid_text(const std::string& prefix, std::span<const std::uint8_t> entity) {
  return prefix + "." + hexadecimal(entity);
}

}  // namespace skein::blackboard::rtps
