// SPDX-License-Identifier: Apache-2.0
// Strict reading of one JSON object: every fault is told, and the keys nobody asked for are kept.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/report/records.hpp"

namespace skein::report {

/// Numbers beyond this magnitude are refused: nothing in a mission is that large.
inline constexpr double kLargestNumber = 1e9;
inline constexpr double kLatestSecond = 1e8;

/// Reads the fields of `object`, which must outlive it. A field that is missing or wrong adds a
/// diagnostic and reads as a default, so that one pass finds all the faults.
class FieldReader {
 public:
  FieldReader(const nlohmann::json& object, Diagnostic where, Diagnostics& faults)
      : object_(object), where_(std::move(where)), faults_(faults) {}

  std::string text(const char* key);
  /// Absent or null is empty. A number reads as its decimal text (an id may be either).
  std::string optional_text(const char* key);
  /// A string, or an integer as its decimal text.
  std::string name(const char* key);
  std::int64_t integer(const char* key);
  std::uint64_t unsigned_integer(const char* key);
  /// An identifier or sequence number: unsigned, or its decimal text (from 2^63 on the log has
  /// text).
  std::uint64_t id(const char* key);
  std::optional<std::uint64_t> optional_id(const char* key);
  double number(const char* key, double limit = kLargestNumber);
  /// Absent or null is none.
  std::optional<double> optional_number(const char* key, double limit = kLargestNumber);
  bool boolean(const char* key);
  Position position(const char* key);
  /// [x, y], on the ground; absent or null is none.
  std::optional<Position> optional_point(const char* key);
  /// A flat list: x, y, z, …; absent is empty.
  std::vector<Position> optional_positions(const char* key);
  /// An array counts its elements; an integer counts itself.
  std::int64_t count(const char* key);
  /// The index of the text in `names`.
  std::size_t one_of(const char* key, std::span<const std::string_view> names);

  /// The fields that nobody asked for, as JSON text; empty if there is none.
  std::string rest() const;

 private:
  const nlohmann::json* find(const char* key);
  const nlohmann::json* require(const char* key);
  void fault(const char* key, std::string message, std::string expected, std::string nearest = {});

  const nlohmann::json& object_;
  Diagnostic where_;
  Diagnostics& faults_;
  std::vector<std::string_view> asked_;
};

/// Text of any JSON value; bytes that are not UTF-8 become U+FFFD. Never throws.
std::string safe_dump(const nlohmann::json& value, int indent = -1);

/// The deepest nesting of brackets in a JSON text, outside strings.
std::size_t nesting(std::string_view json);

/// Parses without exceptions; std::nullopt and one diagnostic when it is not JSON or too deep.
std::optional<nlohmann::json> parse_json(std::string_view text, Diagnostic where,
                                         Diagnostics& faults);

}  // namespace skein::report
