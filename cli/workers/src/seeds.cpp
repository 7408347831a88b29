// SPDX-License-Identifier: Apache-2.0
#include "skein/workers/seeds.hpp"

#include <sstream>

namespace skein::workers {

std::optional<std::pair<std::uint64_t, std::uint64_t>> seeds_of(const std::string& text) {
  const std::size_t dots = text.find("..");
  std::istringstream first(text.substr(0, dots));
  std::istringstream last(dots == std::string::npos ? text : text.substr(dots + 2));
  std::uint64_t a = 0, b = 0;
  if (text.find('-') != std::string::npos) return std::nullopt;
  if (!(first >> a) || !(last >> b) || a > b || !(first >> std::ws).eof() ||
      !(last >> std::ws).eof())
    return std::nullopt;
  return std::pair(a, b);
}

}  // namespace skein::workers
