// SPDX-License-Identifier: Apache-2.0
#include "utf8.hpp"

#include <algorithm>
#include <cstdint>

namespace skein::htn {

namespace {

// How many bytes follow a first byte; more than 3: it cannot begin a character.
std::size_t followers(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  return first >= 0xF0 && first < 0xF5 ? 3 : 4;
}

constexpr std::uint32_t kLeast[] = {0, 0x80, 0x800, 0x10000};

}  // namespace

bool valid_utf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const auto first = static_cast<unsigned char>(bytes[at]);
    if (first < 0x80) continue;
    const std::size_t more = followers(first);
    if (more > 3 || more > bytes.size() - at - 1) return false;
    std::uint32_t character = first & (0x3FU >> more);
    for (std::size_t i = 1; i <= more; ++i) {
      if (!continues_character(bytes[at + i])) return false;
      character = (character << 6U) | (static_cast<unsigned char>(bytes[at + i]) & 0x3FU);
    }
    const bool surrogate = character >= 0xD800 && character < 0xE000;
    if (character < kLeast[more] || character > 0x10FFFF || surrogate) return false;
    at += more;
  }
  return true;
}

std::size_t count_characters(std::string_view bytes) {
  return static_cast<std::size_t>(
      std::count_if(bytes.begin(), bytes.end(), [](char b) { return !continues_character(b); }));
}

}  // namespace skein::htn
