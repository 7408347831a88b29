// SPDX-License-Identifier: Apache-2.0
// Cells of tables for people.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace skein::operate_tool {

/// The text, filled with spaces to `width`; two at least part what is longer from the next cell.
inline std::string cell(std::size_t width, std::string_view text) {
  constexpr std::size_t kLeast = 2;
  std::string result(text);
  result.resize(std::max(width, text.size() + kLeast), ' ');
  return result;
}

}  // namespace skein::operate_tool
