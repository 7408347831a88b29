// SPDX-License-Identifier: Apache-2.0
// What each byte may be at the beginning of, or inside, a Lisp token.
#pragma once

#include <array>
#include <cstdint>

namespace skein::htn {

enum CharacterTraits : std::uint8_t {
  kSpaceByte = 1,
  kTokenByte = 2,   ///< may stand in a token
  kEscapeByte = 4,  ///< \ and |
  kColonByte = 8,
  kHighByte = 16,  ///< part of a UTF-8 sequence
};

constexpr std::array<std::uint8_t, 256> character_table() {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t byte = 0x21; byte < 0x7F; ++byte) table[byte] = kTokenByte;
  for (std::size_t byte = 0x80; byte < 0x100; ++byte) table[byte] = kTokenByte | kHighByte;
  for (const char byte : {'(', ')', '"', '\'', '`', ',', ';'}) {
    table[static_cast<std::uint8_t>(byte)] = 0;
  }
  for (const char byte : {' ', '\t', '\n', '\r', '\f', '\v'}) {
    table[static_cast<std::uint8_t>(byte)] = kSpaceByte;
  }
  table['\\'] |= kEscapeByte;
  table['|'] |= kEscapeByte;
  table[':'] |= kColonByte;
  return table;
}

inline constexpr std::array<std::uint8_t, 256> kCharacters = character_table();

inline std::uint8_t traits_of(char byte) { return kCharacters[static_cast<std::uint8_t>(byte)]; }

}  // namespace skein::htn
