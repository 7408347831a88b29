// SPDX-License-Identifier: Apache-2.0
// A place in a text that is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace skein::htn {

/// A value. The text must outlive it.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;  ///< at most the length of the text

  bool at_end() const { return at >= text.size(); }
  /// The byte so far ahead; beyond the end of the text 0.
  char peek(std::size_t ahead = 0) const {
    return at + ahead < text.size() ? text[at + ahead] : '\0';
  }
  /// As positions are kept. Precondition: the text has less than 2^32 bytes.
  std::uint32_t offset() const { return static_cast<std::uint32_t>(at); }
  /// What was read since `begin`, at most so much ago.
  std::string_view since(std::size_t begin) const { return text.substr(begin, at - begin); }
};

}  // namespace skein::htn
