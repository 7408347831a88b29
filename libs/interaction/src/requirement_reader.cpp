// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "library_reader.hpp"

namespace skein::interaction {

namespace {

using config::Reader;

// "endurance >= 900": absent if there is no relation in it.
std::optional<Requirement> figure_in(const Reader& reader, const std::string& text) {
  const std::size_t begin = text.find_first_of("<>=");
  const std::size_t wide = std::min(text.find("≤"), text.find("≥"));
  const std::size_t at = std::min(begin, wide);
  if (at == std::string::npos) return std::nullopt;
  std::size_t end = at;
  if (wide == at) {
    end += std::string("≤").size();
  } else {
    end = std::min(text.find_first_not_of("<>=", at), text.size());
  }
  Requirement requirement{trimmed(text.substr(0, at)), std::monostate{}};
  const std::string figure = trimmed(text.substr(end));
  char* rest = nullptr;
  const double value = std::strtod(figure.c_str(), &rest);
  const auto relation = relation_of(text.substr(at, end - at));
  if (requirement.capability.empty() || !relation || figure.empty() || *rest != '\0') {
    reader.error("'" + text + "' is no condition", "for example 'endurance >= 900'");
    return requirement;
  }
  requirement.value = Requirement::Bound{*relation, value};
  return requirement;
}

}  // namespace

std::vector<Requirement> read_requirements(const Reader& reader) {
  std::vector<Requirement> all;
  for (const Reader& item : reader.items()) {
    if (item.is_map()) {
      for (const auto& [capability, value] : item.entries()) {
        all.push_back({capability, value.text()});
      }
      continue;
    }
    const std::string text = trimmed(item.text());
    if (const auto figure = figure_in(item, text)) {
      all.push_back(*figure);
    } else {
      if (text.empty()) item.error("an empty condition", "a capability");
      all.push_back({text, std::monostate{}});
    }
  }
  return all;
}

}  // namespace skein::interaction
