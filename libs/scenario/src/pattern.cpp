// SPDX-License-Identifier: Apache-2.0
// Patterns over records of the event log.
#include <algorithm>

#include "skein/scenario/expectation.hpp"

namespace skein::scenario {

namespace {

std::optional<double> as_number(const journal::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

bool same(const journal::Value& a, const journal::Value& b) {
  const auto x = as_number(a);
  const auto y = as_number(b);
  return x && y ? *x == *y : a == b;
}

std::optional<journal::Value> field(const journal::Record& record, const std::string& key) {
  if (key == "kind") return record.kind();
  if (key == "node") return record.node();
  const journal::Value* value = record.find(key);
  return value == nullptr ? std::nullopt : std::optional<journal::Value>(*value);
}

std::string text_of(const journal::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  const std::string line = journal::to_json(journal::Record({}, "", "").with("v", value));
  const std::size_t start = line.find("\"v\":") + 4;
  return line.substr(start, line.size() - 1 - start);
}

}  // namespace

bool Pattern::matches(const journal::Record& record) const {
  return std::all_of(fields.begin(), fields.end(), [&](const auto& wanted) {
    const auto value = field(record, wanted.first);
    return value && std::any_of(wanted.second.begin(), wanted.second.end(),
                                [&](const journal::Value& one) { return same(*value, one); });
  });
}

std::string to_text(const Pattern& pattern) {
  std::string text = "{";
  for (const auto& [key, values] : pattern.fields) {
    if (text.size() > 1) text += ", ";
    text += key + ": ";
    if (values.size() != 1) text += "[";
    for (std::size_t i = 0; i < values.size(); ++i) {
      text += (i > 0 ? ", " : "") + text_of(values[i]);
    }
    if (values.size() != 1) text += "]";
  }
  return text + "}";
}

}  // namespace skein::scenario
