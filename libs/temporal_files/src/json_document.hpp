// SPDX-License-Identifier: Apache-2.0
// A JSON text as values with positions, and its strict reading.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems.hpp"
#include "seconds_text.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

enum class JsonKind { kNull, kFlag, kNumber, kString, kArray, kObject };

struct JsonValue {
  JsonKind kind = JsonKind::kNull;
  int line = 0;
  int column = 0;
  std::string key;               ///< under which an object has it
  std::string text;              ///< of a string; of a number as it is written
  std::vector<JsonValue> items;  ///< of an array or object, in their order
};

/// The whole text; nothing, and problems, when it is not JSON, nests more than 16 deep, has more
/// than four million values, or an object has a key twice.
std::optional<JsonValue> parse_json(std::string_view text, Problems& problems);

/// A value with its path ("arcs[3].min"). Reading a missing value adds a problem.
/// Lifetime: that of the value and of the problems.
class JsonNode {
 public:
  JsonNode(const JsonValue& value, std::string path, Problems& problems)
      : value_(&value), path_(std::move(path)), problems_(&problems) {}

  /// Whether it is an object; its keys that are none of these are problems.
  bool is_object_of(std::initializer_list<std::string_view> keys) const;
  /// Whether it is an object; any keys.
  bool is_object() const;
  bool has(std::string_view key) const { return value_of(key) != nullptr; }
  /// The value of a key; nothing and a problem if it is missing.
  std::optional<JsonNode> at(std::string_view key) const;
  /// The value of a key; nothing if it is missing.
  std::optional<JsonNode> find(std::string_view key) const;
  /// The items of an array; empty and a problem if the value is no array.
  std::vector<JsonNode> items() const;

  std::optional<std::string> name() const;
  /// A finite number of seconds, exact.
  std::optional<Ticks> seconds() const;
  /// As seconds(); null is `open`.
  std::optional<Ticks> bound(Ticks open) const;
  /// A whole number from 0 to `most`.
  std::optional<std::uint32_t> position(std::size_t most) const;

  const JsonValue& value() const { return *value_; }
  Place place() const { return {value_->line, value_->column, path_}; }
  void wrong(std::string message, std::string expected = "") const {
    problems_->add(place(), std::move(message), std::move(expected));
  }
  void wrong_kind(std::string expected) const;

 private:
  const JsonValue* value_of(std::string_view key) const;

  const JsonValue* value_;
  std::string path_;
  Problems* problems_;
};

/// Reports why a number was refused.
void add_bad_seconds(Problems& problems, const Place& place, std::string_view text, BadSeconds why);

/// A string as it is written in JSON, quotes included; the text is UTF-8.
std::string json_string(std::string_view text);
/// Seconds as a JSON number, or null for an infinite bound.
std::string json_bound(Ticks ticks);

}  // namespace skein::temporal
