// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/lost_uav.hpp"

namespace skein::mission {

namespace {

constexpr std::string_view kLost = "lost ";

}  // namespace

std::string lost_message(std::string_view uav) { return std::string(kLost) + std::string(uav); }

std::optional<std::string> uav_lost_in(std::string_view message) {
  if (!message.starts_with(kLost) || message.size() == kLost.size()) return std::nullopt;
  return std::string(message.substr(kLost.size()));
}

}  // namespace skein::mission
