// SPDX-License-Identifier: Apache-2.0
// How text for people is marked: with a terminal's colours, or not at all.
#pragma once

#include <string>
#include <string_view>

namespace skein::htn {

/// Sequences put before the text they mark; `plain` ends each. All empty: plain text.
struct TextStyle {
  std::string_view bold;
  std::string_view dim;
  std::string_view good;
  std::string_view bad;
  std::string_view accent;
  std::string_view plain;

  std::string mark(std::string_view how, std::string_view text) const {
    std::string out(how);
    out.append(text).append(plain);
    return out;
  }
};

inline constexpr TextStyle kPlainText{};
inline constexpr TextStyle kTerminalText{"\033[1m",  "\033[2m",  "\033[32m",
                                         "\033[31m", "\033[36m", "\033[0m"};

}  // namespace skein::htn
