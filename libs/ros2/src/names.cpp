// SPDX-License-Identifier: Apache-2.0
#include "skein/ros2/names.hpp"

#include <cctype>

namespace skein::ros2 {

std::string token_of(std::string_view name) {
  std::string token;
  for (const char c : name) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (kept) {
      token += c;
    } else if (token.empty() || token.back() != '_') {
      token += '_';
    }
  }
  const bool begins_badly =
      token.empty() || std::isdigit(static_cast<unsigned char>(token[0])) != 0;
  return begins_badly ? "uav_" + token : token;
}

std::string topic_of(std::string_view name) { return "rt/" + std::string(name); }

}  // namespace skein::ros2
