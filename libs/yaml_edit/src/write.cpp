// SPDX-License-Identifier: Apache-2.0
#include "write.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "skein/foundation/contract.hpp"

namespace skein::yaml_edit {

namespace {

using config::Value;

constexpr int kDeepestShort = 3;

/// Whether a plain scalar says this text in any place. On the safe side.
bool is_plain(const std::string& text) {
  if (text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL")
    return false;
  static constexpr std::string_view kNotFirst = "-?:,[]{}#&*!|>'\"%@`= ";
  static constexpr std::string_view kNowhere = ",[]{}#:?\"'\\";
  const bool number = text.find_first_not_of("-.0123456789") == std::string::npos && text != "-" &&
                      text.find_first_of("0123456789") != std::string::npos;
  if (number) return true;
  if (kNotFirst.find(text.front()) != std::string_view::npos || text.back() == ' ') return false;
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return c >= 0x20 && c != 0x7f && kNowhere.find(static_cast<char>(c)) == std::string_view::npos;
  });
}

std::string in_quotes(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (code < 0x20 || code == 0x7f) {
      std::array<char, 8> hex{};
      std::snprintf(hex.data(), hex.size(), "\\x%02x", code);
      quoted += hex.data();
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

bool is_empty(const Value& value) { return value.items.empty() && value.entries.empty(); }
bool is_collection(const Value& value) {
  return value.kind == Value::Kind::kSequence || value.kind == Value::Kind::kMap;
}

int depth_of(const Value& value) {
  if (!is_collection(value)) return 0;
  int deepest = 0;
  for (const Value& item : value.items) deepest = std::max(deepest, depth_of(item));
  for (const auto& [key, one] : value.entries) deepest = std::max(deepest, depth_of(one));
  return deepest + 1;
}

bool is_map(const Value& value) { return value.kind == Value::Kind::kMap; }

/// Several maps stand below each other, but for those of a clause: a list in a list.
bool may_be_short(const Value& value, bool in_list) {
  const bool several_maps = std::count_if(value.items.begin(), value.items.end(), is_map) > 1;
  if ((several_maps && !in_list) || depth_of(value) > kDeepestShort) return false;
  return std::all_of(value.items.begin(), value.items.end(),
                     [](const Value& item) { return may_be_short(item, true); }) &&
         std::all_of(value.entries.begin(), value.entries.end(),
                     [](const auto& entry) { return may_be_short(entry.value, false); });
}

/// Behind a key or a dash.
std::string behind(const Value& value, std::size_t column, std::size_t used, bool of_key) {
  if (!is_collection(value) || is_empty(value) || is_short(value, used)) {
    return value.kind == Value::Kind::kNull ? "" : " " + flow_text(value);
  }
  if (!of_key) return " " + block_text(value, column + 2);
  return "\n" + std::string(column + 2, ' ') + block_text(value, column + 2);
}

}  // namespace

std::string scalar_text(const std::string& text, bool quoted) {
  return quoted || !is_plain(text) ? in_quotes(text) : text;
}

std::string flow_text(const Value& value) {
  std::string text;
  const auto join = [&](const std::string& piece) { text += (text.empty() ? "" : ", ") + piece; };
  switch (value.kind) {
    case Value::Kind::kNull:
      return "null";
    case Value::Kind::kScalar:
      return scalar_text(value.scalar, value.quoted);
    case Value::Kind::kSequence:
      for (const Value& item : value.items) join(flow_text(item));
      return "[" + text + "]";
    case Value::Kind::kMap:
      break;
  }
  for (const auto& [key, one] : value.entries) {
    join(scalar_text(key, false) + ": " + flow_text(one));
  }
  return "{" + text + "}";
}

bool is_short(const Value& value, std::size_t column) {
  return !is_collection(value) || is_empty(value) ||
         (may_be_short(value, false) && column + flow_text(value).size() <= kWidth);
}

std::string block_text(const Value& value, std::size_t column) {
  SKEIN_EXPECTS(is_collection(value) && !is_empty(value));
  std::string text;
  const auto begin = [&] {
    if (!text.empty()) text += "\n" + std::string(column, ' ');
  };
  for (const Value& item : value.items) {
    begin();
    text += "-" + behind(item, column, column + 2, false);
  }
  for (const auto& [key, one] : value.entries) {
    begin();
    const std::string name = scalar_text(key, false) + ":";
    text += name + behind(one, column, column + name.size() + 1, true);
  }
  return text;
}

}  // namespace skein::yaml_edit
