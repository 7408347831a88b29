// SPDX-License-Identifier: Apache-2.0
// A line of the event log as a struct of its kind (lines/*.hpp), to and from a Record.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::journal {

/// The text of a field; made from any string type.
struct Text : std::string {
  Text() = default;
  Text(std::string text) : std::string(std::move(text)) {}
  Text(std::string_view text) : std::string(text) {}
  Text(const char* text) : std::string(text) {}
};

/// A text field that is left out of the line if it is empty.
struct OptionalText : Text {
  using Text::Text;
};

/// A list field that is left out of the line if it has no elements.
struct OptionalNumbers : std::vector<double> {
  OptionalNumbers() = default;
  OptionalNumbers(std::vector<double> numbers) : std::vector<double>(std::move(numbers)) {}
};

namespace detail {

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;
template <>
inline constexpr bool kIsOptional<OptionalText> = true;
template <>
inline constexpr bool kIsOptional<OptionalNumbers> = true;

template <class T>
void put(Record& record, const char* name, T& value) {
  if constexpr (std::is_base_of_v<std::string, T>) {
    if (!kIsOptional<T> || !value.empty()) record.with(name, std::string(std::move(value)));
  } else if constexpr (std::is_base_of_v<std::vector<double>, T>) {
    if (!kIsOptional<T> || !value.empty()) record.with(name, std::vector<double>(std::move(value)));
  } else if constexpr (kIsOptional<T>) {
    if (value) record.with(name, *value);
  } else {
    record.with(name, value);
  }
}

/// False: the field has another shape.
bool take(const Value& value, bool& to);
bool take(const Value& value, std::int64_t& to);
bool take(const Value& value, std::uint64_t& to);
bool take(const Value& value, double& to);
bool take(const Value& value, std::string& to);
bool take(const Value& value, std::vector<double>& to);
template <class T>
bool take(const Value& value, std::optional<T>& to) {
  return take(value, to.emplace());
}

}  // namespace detail

/// The line as a record: `Line` is one of lines/*.hpp.
template <class Line>
Record record_of(MissionTime at, std::string node, Line line) {
  Record record(at, std::move(node), std::string(Line::kKind));
  Line::fields(line, [&](const char* name, auto& value) { detail::put(record, name, value); });
  return record;
}

/// The record as a line; nothing if it is of another kind, or if a mandatory field is missing or
/// has another type.
template <class Line>
std::optional<Line> read_as(const Record& record) {
  if (record.kind() != Line::kKind) return std::nullopt;
  std::optional<Line> line(std::in_place);
  bool sound = true;
  Line::fields(*line, [&]<class T>(const char* name, T& value) {
    const Value* found = record.find(name);
    sound = sound && (found == nullptr ? detail::kIsOptional<T> : detail::take(*found, value));
  });
  if (!sound) line.reset();
  return line;
}

}  // namespace skein::journal
