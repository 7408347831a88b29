// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_text/fault_scripts.hpp"

#include <algorithm>
#include <charconv>
#include <variant>

#include "skein/config/parse.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::scenario_text {
namespace {

using config::Value;
/// A key, or the number of an item.
using Step = std::variant<std::string, std::size_t>;
using Path = std::vector<Step>;

/// Of "radio.cuts[1].from".
Path path_of(const std::string& text) {
  Path path;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(".[]", at), text.size());
    std::size_t number = 0;
    const bool is_item =
        at > 0 && text[at - 1] == '[' &&
        std::from_chars(&text[at], &text[at] + (end - at), number).ec == std::errc();
    if (is_item) {
      path.emplace_back(number);
    } else if (end > at) {
      path.emplace_back(text.substr(at, end - at));
    }
    at = end + 1;
  }
  return path;
}

std::string text_of(const Path& path) {
  std::string text;
  for (const Step& step : path) {
    if (const auto* number = std::get_if<std::size_t>(&step)) {
      text += "[" + std::to_string(*number) + "]";
    } else {
      text += (text.empty() ? "" : ".") + std::get<std::string>(step);
    }
  }
  return text;
}

const Value* child_of(const Value& value, const Step& step) {
  if (const auto* key = std::get_if<std::string>(&step)) return value.find(*key);
  const std::size_t number = std::get<std::size_t>(step);
  return number < value.items.size() ? &value.items[number] : nullptr;
}

/// The value at the path, or the last on the way that there is.
const Value& deepest(const Value& document, const Path& path) {
  const Value* value = &document;
  for (const Step& step : path) {
    const Value* next = child_of(*value, step);
    if (next == nullptr) break;
    value = next;
  }
  return *value;
}

const Value* radio_key(const Value& document, const Step& key) {
  const Value* radio = document.find("radio");
  return radio == nullptr ? nullptr : child_of(*radio, key);
}

/// Whose the value is; its path becomes that in this document. Keys are of the last that has them,
/// cuts come after each other.
std::size_t origin_of(Path& path, const std::vector<Value>& documents) {
  if (path.size() < 2 || path[0] != Step("radio")) return 0;
  const bool is_cut = path[1] == Step("cuts") && path.size() > 2 && path[2].index() == 1;
  if (!is_cut) {
    for (std::size_t i = documents.size(); i-- > 1;)
      if (radio_key(documents[i], path[1]) != nullptr) return i;
    return 0;
  }
  auto& number = std::get<std::size_t>(path[2]);
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const Value* cuts = radio_key(documents[i], path[1]);
    const std::size_t count = cuts == nullptr ? 0 : cuts->items.size();
    if (number < count) return i;
    number -= count;
  }
  return 0;
}

}  // namespace

Diagnostics problems_of(const std::vector<NamedText>& files) {
  Diagnostics all;
  for (const NamedText& one : files)
    if (const auto parsed = config::parse_yaml(one.text, one.file); !parsed)
      all.append(parsed.error());
  return all;
}

Diagnostics as_written(const Diagnostics& errors, const std::string& joined,
                       const std::vector<NamedText>& files) {
  std::vector<Value> documents;
  for (const NamedText& one : files) {
    auto parsed = config::parse_yaml(one.text, one.file);
    SKEIN_EXPECTS(parsed.has_value());
    documents.push_back(std::move(*parsed));
  }
  Diagnostics all;
  for (Diagnostic error : errors.all()) {
    if (error.file == joined) {
      Path path = path_of(error.path);
      const std::size_t origin = origin_of(path, documents);
      const Value& value = deepest(documents[origin], path);
      error.file = files[origin].file;
      error.path = text_of(path);
      error.line = value.line;
      error.column = value.column;
    }
    all.add(std::move(error));
  }
  return all;
}

}  // namespace skein::scenario_text
