// SPDX-License-Identifier: Apache-2.0
// Concatenation of texts, for people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace skein {

/// "a; b; c" of a, b, c with "; " between them. Empty texts at the front leave nothing.
inline std::string joined(const std::vector<std::string>& texts, std::string_view between) {
  std::string all;
  for (const std::string& one : texts) {
    if (!all.empty()) all += between;
    all += one;
  }
  return all;
}

}  // namespace skein
