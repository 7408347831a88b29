// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/alarm_name.hpp"

#include <algorithm>
#include <cctype>

namespace skein::mission {

namespace {
constexpr std::string_view kPrefix = "alarm:";
}

std::string name_of_alarm(std::uint64_t id) { return std::string(kPrefix) + std::to_string(id); }

bool is_name_of_alarm(std::string_view name) {
  if (!name.starts_with(kPrefix)) return false;
  const std::string_view number = name.substr(kPrefix.size());
  return !number.empty() && std::all_of(number.begin(), number.end(),
                                        [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace skein::mission
