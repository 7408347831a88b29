// SPDX-License-Identifier: Apache-2.0
// UTF-8: whether bytes are it, and how many characters they are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace skein::htn {

/// Byte that continues a character begun before.
inline bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Shortest forms only, no surrogates, nothing beyond U+10FFFF.
bool valid_utf8(std::string_view bytes);

/// The first `most` characters and "…", or the text if it has no more.
std::string clipped(std::string text, std::size_t most);

/// Small letters for capitals of the Latin, Greek, Cyrillic and Armenian alphabets; all else as it
/// is, and what is no UTF-8.
std::string lowered(std::string_view text);

/// Characters, counting each byte that begins one.
std::size_t count_characters(std::string_view bytes);

}  // namespace skein::htn
