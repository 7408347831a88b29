// SPDX-License-Identifier: Apache-2.0
#include "path.hpp"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

template <std::size_t... I>
wire::Sample fresh_sample(wire::Slot slot, std::index_sequence<I...>) {
  wire::Sample sample;
  const auto wanted = static_cast<std::size_t>(slot);
  (void)((I == wanted ? (sample.emplace<I>(), true) : false) || ...);
  return sample;
}

/// Where a path leaves what a document has: the names there are, or nothing if it does not.
std::optional<std::vector<std::string>> names_where_lost(const Json& document, const Path& path) {
  const Json* at = &document;
  for (const Step& step : path) {
    if (at->is_array() && at->empty()) return std::nullopt;
    if (at->is_array()) at = &at->front();
    if (step.index) continue;
    const auto found = at->is_object() ? at->find(step.name) : at->end();
    if (at->is_object() && found != at->end()) {
      at = &*found;
      continue;
    }
    std::vector<std::string> names;
    if (at->is_object())
      for (const auto& [name, value] : at->items()) names.push_back(name);
    return names;
  }
  return std::nullopt;
}

void collect(const Json& at, const Path& path, std::size_t step, std::vector<const Json*>& found) {
  if (at.is_array() && (step == path.size() ? step > 0 : !path[step].index)) {
    for (const Json& element : at) collect(element, path, step, found);
    return;
  }
  if (step == path.size()) {
    found.push_back(&at);
    return;
  }
  const Step& next = path[step];
  if (next.index) {
    if (at.is_array() && *next.index < at.size()) collect(at[*next.index], path, step + 1, found);
  } else if (at.is_object()) {
    const auto child = at.find(next.name);
    if (child != at.end()) collect(*child, path, step + 1, found);
  }
}

}  // namespace

Result<Path, Failure> parse_path(std::string_view text) {
  Path path;
  const auto wrong = [&] { return failure("'" + std::string(text) + "' names no field"); };
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '[') {
      const std::size_t end = text.find(']', at);
      std::size_t index = 0;
      if (end == std::string_view::npos || path.empty()) return wrong();
      const auto [stop, error] = std::from_chars(text.data() + at + 1, text.data() + end, index);
      if (error != std::errc() || stop != text.data() + end) return wrong();
      path.push_back({"", index});
      at = end + 1;
      continue;
    }
    if (!path.empty() && text[at++] != '.') return wrong();
    const std::size_t begin = at;
    while (at < text.size() && is_name(text[at])) ++at;
    if (at == begin) return wrong();
    path.push_back({std::string(text.substr(begin, at - begin)), {}});
  }
  if (path.empty()) return wrong();
  return path;
}

std::vector<const Json*> values_at(const Json& document, const Path& path) {
  std::vector<const Json*> found;
  collect(document, path, 0, found);
  return found;
}

Diagnostics check_path(const Path& path, const std::string& text,
                       const std::vector<wire::Slot>& slots) {
  Diagnostics diagnostics;
  std::vector<std::string> names;
  for (const wire::Slot slot : slots) {
    const Json document = Json::parse(
        wire::to_json(fresh_sample(slot, std::make_index_sequence<wire::kSlotCount>{})));
    const auto lost = names_where_lost(document, path);
    if (!lost) return {};
    if (names.empty()) names = *lost;
  }
  if (slots.empty()) return {};
  std::string name;  // the first that is not there, as far as that can be told
  for (const Step& step : path)
    if (!step.name.empty() && std::ranges::find(names, step.name) == names.end()) name = step.name;
  diagnostics.add({"", 0, 0, "",
                   "no field '" + text + "' in " + std::string(wire::slot_name(slots.front())),
                   names.empty() ? "a shorter path" : "one of " + joined(names, ", "),
                   nearest_name(name, names)});
  return diagnostics;
}

}  // namespace skein::spy_tool
