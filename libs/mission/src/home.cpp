// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/home.hpp"

#include <algorithm>
#include <cctype>

namespace skein::mission {

namespace {

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

}  // namespace

bool means_home(std::string_view place) {
  return same_letters(place, "home") || same_letters(place, "zero");
}

}  // namespace skein::mission
