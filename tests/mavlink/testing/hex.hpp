// SPDX-License-Identifier: Apache-2.0
// Bytes as people write them.
#pragma once

#include <string>

#include "skein/mavlink/frame.hpp"

namespace skein::mavlink {

inline std::string hex(const Bytes& bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 0xfU];
  }
  return text;
}

}  // namespace skein::mavlink
