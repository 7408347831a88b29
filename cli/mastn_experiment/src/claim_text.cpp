// SPDX-License-Identifier: Apache-2.0
#include "claim_text.hpp"

#include <array>
#include <cstdio>

namespace skein::temporal {

std::string rounded(double value, int places) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", places, value);
  return text.data();
}

std::string shape_text(double agents, double external) {
  return "N = " + rounded(agents, 0) + ", E = " + rounded(external, 0);
}

}  // namespace skein::temporal
