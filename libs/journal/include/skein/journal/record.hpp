// SPDX-License-Identifier: Apache-2.0
// One line of the event log: what happened, when, according to which node.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::journal {

/// A field of a record. Lists of numbers hold positions and velocities: metres, ENU.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// A record: instant, node, kind, then fields in the order given. The kinds and their fields are
/// the contract between the nodes, the expectations and the report: docs/journal.md. Value type;
/// equal records give equal lines, byte for byte.
class Record {
 public:
  Record() = default;
  Record(MissionTime at, std::string node, std::string kind)
      : at_(at), node_(std::move(node)), kind_(std::move(kind)) {}

  /// Appends a field: a truth value, a number, text or a list of numbers. A key is given once;
  /// giving it again is the caller's defect and makes the first one count. An id of 2^63 or more is
  /// written as decimal text.
  template <class T>
  Record& with(std::string key, T value) {
    fields_.emplace_back(std::move(key), to_value(std::move(value)));
    return *this;
  }

  MissionTime at() const { return at_; }
  const std::string& node() const { return node_; }
  const std::string& kind() const { return kind_; }
  const std::vector<std::pair<std::string, Value>>& fields() const { return fields_; }
  /// The field with this key, or null. Cost: linear in the fields.
  const Value* find(std::string_view key) const;
  /// The field as text, or empty if it is absent or not text.
  std::string_view text(std::string_view key) const;
  /// The field as a number, or `otherwise`.
  double number(std::string_view key, double otherwise = 0) const;
  bool truth(std::string_view key) const;
  /// The field as a list of numbers, or empty.
  std::vector<double> numbers(std::string_view key) const;

  bool operator==(const Record&) const = default;

 private:
  template <class T>
  static Value to_value(T value) {
    if constexpr (std::is_same_v<T, std::uint64_t>) {
      return from_unsigned(value);
    } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
      return static_cast<std::int64_t>(value);
    } else if constexpr (std::is_convertible_v<T, std::string_view>) {
      return std::string(std::string_view(value));
    } else {
      return Value(std::move(value));
    }
  }
  static Value from_unsigned(std::uint64_t number);

  MissionTime at_;
  std::string node_;
  std::string kind_;
  std::vector<std::pair<std::string, Value>> fields_;
};

/// One JSON object without a newline: keys at, node, kind, then the fields in order. Instants are
/// exact to the nanosecond; numbers are written in the shortest form that reads back the same.
/// Numbers that are not finite are written as null.
std::string to_json(const Record& record);

/// Reads a line as `to_json` writes it. Fields of other shapes (objects, mixed lists, null) are
/// dropped; a missing at, node or kind, or a line that is no JSON object, is a failure.
Result<Record, Failure> parse_record(std::string_view line);

/// Rounds to a thousandth: enough for positions, and short in the log.
double rounded(double x);
std::vector<double> rounded(std::vector<double> xs);

}  // namespace skein::journal
