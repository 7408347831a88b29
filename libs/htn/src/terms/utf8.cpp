// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/utf8.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace skein::htn {

namespace {

// How many bytes follow a first byte; more than 3: it cannot begin a character.
std::size_t followers(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  return first >= 0xF0 && first < 0xF5 ? 3 : 4;
}

/// Capitals from `first` to `last`; their small letters stand `by` further, or, in pairs, behind
/// each.
struct Capitals {
  std::uint32_t first;
  std::uint32_t last;
  std::uint32_t by;
};
constexpr Capitals kCapitals[] = {{0x00C0, 0x00D6, 32}, {0x00D8, 0x00DE, 32}, {0x0386, 0x0386, 38},
                                  {0x0388, 0x038A, 37}, {0x038C, 0x038C, 64}, {0x038E, 0x038F, 63},
                                  {0x0391, 0x03A1, 32}, {0x03A3, 0x03AB, 32}, {0x0400, 0x040F, 80},
                                  {0x0410, 0x042F, 32}, {0x0531, 0x0556, 48}};
/// Runs where capitals and small letters alternate; `odd`: the capitals are the odd ones.
struct Pairs {
  std::uint32_t first;
  std::uint32_t last;
  bool odd;
};
constexpr Pairs kPairs[] = {
    {0x0100, 0x012F, false}, {0x0132, 0x0137, false}, {0x0139, 0x0148, true},
    {0x014A, 0x0177, false}, {0x0179, 0x017E, true},  {0x01CD, 0x01DC, true},
    {0x01DE, 0x01EF, false}, {0x01F8, 0x021F, false}, {0x0222, 0x0233, false},
    {0x03D8, 0x03EF, false}, {0x0460, 0x0481, false}, {0x048A, 0x04BF, false},
    {0x04C1, 0x04CE, true},  {0x04D0, 0x052F, false}};

// Of characters of two bytes.
std::uint32_t small_letter(std::uint32_t letter) {
  if (letter == 0x0178) return 0x00FF;
  for (const Capitals& run : kCapitals) {
    if (letter >= run.first && letter <= run.last) return letter + run.by;
  }
  for (const Pairs& run : kPairs) {
    const bool capital = (letter % 2 == 1) == run.odd;
    if (letter >= run.first && letter <= run.last && capital) return letter + 1;
  }
  return letter;
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
  constexpr std::uint64_t kOnes = 0x0101010101010101ULL;
  std::size_t characters = 0;
  for (; bytes.size() >= 8; bytes.remove_prefix(8)) {  // those that continue one are 10xxxxxx
    std::uint64_t eight = 0;
    std::memcpy(&eight, bytes.data(), 8);
    const std::uint64_t continuing = (eight >> 7U) & ~(eight >> 6U) & kOnes;
    characters += 8 - ((continuing * kOnes) >> 56U);
  }
  return characters +
         static_cast<std::size_t>(std::count_if(bytes.begin(), bytes.end(),
                                                [](char b) { return !continues_character(b); }));
}

std::string lowered(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t more = followers(first);
    if (first < 0x80) {
      out += first >= 'A' && first <= 'Z' ? static_cast<char>(first - 'A' + 'a') : text[at];
      ++at;
    } else if (more == 1 && at + 1 < text.size() && continues_character(text[at + 1])) {
      const std::uint32_t letter = small_letter(((first & 0x1FU) << 6U) |
                                                (static_cast<unsigned char>(text[at + 1]) & 0x3FU));
      out += static_cast<char>(0xC0U | (letter >> 6U));
      out += static_cast<char>(0x80U | (letter & 0x3FU));
      at += 2;
    } else {
      out += text[at++];
    }
  }
  return out;
}

std::string clipped(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t at = 0;
  for (std::size_t seen = 0; at < text.size(); ++at) {
    if (!continues_character(text[at]) && seen++ == most) break;
  }
  if (at == text.size()) return text;
  text.resize(at);
  return text + "…";
}

}  // namespace skein::htn
