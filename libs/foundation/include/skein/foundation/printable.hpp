// SPDX-License-Identifier: Apache-2.0
// Foreign text, made safe for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace skein {

/// The text with each control character except tab and newline (C0, DEL, and C1 in UTF-8) replaced
/// by U+FFFD, so that it cannot control the terminal. The number of characters stays the same.
inline std::string printable(std::string_view text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const auto next = static_cast<unsigned char>(at + 1 < text.size() ? text[at + 1] : ' ');
    const bool c1 = byte == 0xC2 && next >= 0x80 && next < 0xA0;
    if (c1 || byte == 0x7F || (byte < ' ' && byte != '\t' && byte != '\n'))
      out += kReplacement;
    else
      out += text[at];
    if (c1) ++at;
  }
  return out;
}

}  // namespace skein
