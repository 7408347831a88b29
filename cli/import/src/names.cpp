// SPDX-License-Identifier: Apache-2.0
#include "names.hpp"

#include <algorithm>
#include <cctype>

#include "skein/mission/home.hpp"

namespace skein::import_tool {

std::string plain_name(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 || c == '_');
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  name.resize(std::min<std::size_t>(name.size(), 32));
  while (!name.empty() && name.back() == '-') name.pop_back();
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "null" ? "" : name;
}

std::string Names::make(std::string_view text, const std::string& otherwise) {
  std::string name = plain_name(text);
  if (name.empty()) name = otherwise;
  if (!mission::means_home(name) && taken_.insert(name).second) return name;
  for (int number = 2;; ++number) {
    const std::string numbered = name + "-" + std::to_string(number);
    if (taken_.insert(numbered).second) return numbered;
  }
}

}  // namespace skein::import_tool
