// SPDX-License-Identifier: Apache-2.0
// Strict reading of one JSON object: every fault is reported, and unknown keys are kept.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/journal/kinds.hpp"
#include "skein/report/records.hpp"

namespace skein::report {

/// Numbers of a larger magnitude are faults, since no figure of a mission is that large.
inline constexpr double kLargestNumber = 1e9;
inline constexpr double kLatestSecond = 1e8;

/// Reads the fields of `object`, which must outlive the reader. A missing or wrong field adds a
/// diagnostic and reads as a default, so that one pass finds all the faults.
class FieldReader {
 public:
  FieldReader(const nlohmann::json& object, Diagnostic where, Diagnostics& faults)
      : object_(object), where_(std::move(where)), faults_(faults) {}

  std::string text(const char* key);
  /// Absent or null is empty.
  std::string optional_text(const char* key);
  /// A string, or an integer as its decimal text.
  std::string name(const char* key);
  std::int64_t integer(const char* key);
  std::uint64_t unsigned_integer(const char* key);
  double number(const char* key, double limit = kLargestNumber);
  /// Absent or null is none.
  std::optional<double> optional_number(const char* key);
  bool boolean(const char* key);
  Position position(const char* key);

  /// A line of the event log of the kind `Line` (skein/journal/lines).
  template <class Line>
  Line line() {
    Line read;
    Line::fields(read, [this](const char* key, auto& value) { take(key, value); });
    return read;
  }
  // Conversions of a key's value that has been read already.
  /// The index of the text in `names`.
  std::size_t one_of(const char* key, const std::string& text,
                     std::span<const std::string_view> names);
  /// [x, y, z].
  Position position(const char* key, const std::vector<double>& numbers);
  /// [x, y], on the ground; empty is none.
  std::optional<Position> point(const char* key, const std::vector<double>& numbers);
  /// A flat list: x, y, z, …
  std::vector<Position> positions(const char* key, const std::vector<double>& numbers);

  /// The fields that no other method has read, as JSON text; empty if there is none.
  std::string rest() const;

 private:
  const nlohmann::json* find(const char* key);
  const nlohmann::json* require(const char* key);
  /// Adds a diagnostic, only the first one for each key.
  void fault(const char* key, std::string message, std::string expected, std::string nearest = {});

  // Required fields. An identifier of 2^63 or more is decimal text in the log.
  void take(const char* key, bool& to) { to = boolean(key); }
  void take(const char* key, double& to) { to = number(key); }
  void take(const char* key, journal::Text& to) { to = text(key); }
  void take(const char* key, std::int64_t& to) { to = integer(key); }
  void take(const char* key, std::uint64_t& to);
  void take(const char* key, std::vector<double>& to);
  // Optional fields, which may be absent or null.
  void take(const char* key, journal::OptionalText& to) { to = optional_text(key); }
  template <class T>
  requires journal::kMayBeLeftOut<T>
  void take(const char* key, T& to) {
    if (find(key) == nullptr) return;
    if constexpr (requires { to.emplace(); }) {
      take(key, to.emplace());
    } else {
      take(key, static_cast<std::vector<double>&>(to));
    }
  }

  const nlohmann::json& object_;
  Diagnostic where_;
  Diagnostics& faults_;
  std::vector<std::string_view> asked_, wrong_;
};

/// Text of any JSON value; bytes that are not UTF-8 become U+FFFD. Never throws.
std::string safe_dump(const nlohmann::json& value, int indent = -1);

/// The deepest nesting of brackets in a JSON text, outside strings.
std::size_t nesting(std::string_view json);

/// Parses without exceptions; std::nullopt and one diagnostic when it is not JSON or too deep.
std::optional<nlohmann::json> parse_json(std::string_view text, Diagnostic where,
                                         Diagnostics& faults);

}  // namespace skein::report
