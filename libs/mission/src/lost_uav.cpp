// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/lost_uav.hpp"

namespace skein::mission {

namespace {

constexpr std::string_view kLost = "lost ", kFound = "found ";

std::optional<std::string> uav_in(std::string_view message, std::string_view word) {
  if (!message.starts_with(word) || message.size() == word.size()) return std::nullopt;
  return std::string(message.substr(word.size()));
}

}  // namespace

std::string lost_message(std::string_view uav) { return std::string(kLost) + std::string(uav); }
std::string found_message(std::string_view uav) { return std::string(kFound) + std::string(uav); }

std::optional<std::string> uav_lost_in(std::string_view message) { return uav_in(message, kLost); }
std::optional<std::string> uav_found_in(std::string_view message) {
  return uav_in(message, kFound);
}

}  // namespace skein::mission
