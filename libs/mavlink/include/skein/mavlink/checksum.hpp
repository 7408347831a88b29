// SPDX-License-Identifier: Apache-2.0
// The checksum of MAVLink frames.
#pragma once

#include <cstdint>
#include <string_view>

namespace skein::mavlink {

/// CRC-16/MCRF4XX ("X.25" in the guide of MAVLink). Source: mavlink.io/en/guide/serialization.html.
class Checksum {
 public:
  constexpr void add(std::uint8_t byte) {
    auto mixed = static_cast<std::uint8_t>(byte ^ (value_ & 0xffU));
    mixed = static_cast<std::uint8_t>(mixed ^ (mixed << 4U));
    value_ =
        static_cast<std::uint16_t>((value_ >> 8U) ^ (mixed << 8U) ^ (mixed << 3U) ^ (mixed >> 4U));
  }
  constexpr void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint8_t>(c));
  }
  constexpr std::uint16_t value() const { return value_; }

 private:
  std::uint16_t value_ = 0xffff;
};

}  // namespace skein::mavlink
