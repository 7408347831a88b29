// SPDX-License-Identifier: Apache-2.0
#include "reading/field_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "skein/foundation/nearest.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kDeepest = 64;

bool is_number_of_a_mission(const nlohmann::json& value) {
  return value.is_number() && std::abs(value.get<double>()) <= kLargestNumber;
}

}  // namespace

const nlohmann::json* FieldReader::find(const char* key) {
  asked_.push_back(key);
  const auto it = object_.find(key);
  return it == object_.end() || it->is_null() ? nullptr : &*it;
}

const nlohmann::json* FieldReader::require(const char* key) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) fault(key, "missing key", "");
  return value;
}

void FieldReader::fault(const char* key, std::string message, std::string expected,
                        std::string nearest) {
  if (std::find(wrong_.begin(), wrong_.end(), key) != wrong_.end()) return;
  wrong_.push_back(key);
  Diagnostic d = where_;
  d.path = d.path.empty() ? key : d.path + "." + key;
  d.message = std::move(message);
  d.expected = std::move(expected);
  d.nearest = std::move(nearest);
  faults_.add(std::move(d));
}

std::string FieldReader::text(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  fault(key, "not a text", "a string");
  return {};
}

std::string FieldReader::name(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  if (value->is_number_integer()) return value->dump();
  fault(key, "not a name", "a string or an integer");
  return {};
}

std::string FieldReader::optional_text(const char* key) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  fault(key, "not a text", "a string");
  return {};
}

std::int64_t FieldReader::integer(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return 0;
  const bool fits = value->is_number_unsigned()
                        ? value->get<std::uint64_t>() <= std::uint64_t{INT64_MAX}
                        : value->is_number_integer();
  if (fits) return value->get<std::int64_t>();
  fault(key, "not an integer", "a 64-bit integer");
  return 0;
}

void FieldReader::take(const char* key, std::uint64_t& to) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return;
  if (value->is_number_unsigned()) {
    to = value->get<std::uint64_t>();
    return;
  }
  if (value->is_string()) {
    const auto& text = value->get_ref<const std::string&>();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), to);
    if (error == std::errc() && end == text.data() + text.size()) return;
  }
  fault(key, "not an identifier", "an unsigned 64-bit integer");
}

void FieldReader::take(const char* key, std::vector<double>& to) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return;
  if (!value->is_array() || !std::all_of(value->begin(), value->end(), is_number_of_a_mission)) {
    return fault(key, "not a list of numbers", "[x, y, …]");
  }
  to = value->get<std::vector<double>>();
}

std::uint64_t FieldReader::unsigned_integer(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr || value->is_number_unsigned()) {
    return value == nullptr ? 0 : value->get<std::uint64_t>();
  }
  fault(key, "not an unsigned integer", "an unsigned 64-bit integer");
  return 0;
}

double FieldReader::number(const char* key, double limit) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return 0.0;
  const double number = value->is_number() ? value->get<double>() : std::nan("");
  if (std::abs(number) <= limit) return number;
  fault(key, value->is_number() ? "number out of range" : "not a number", "a number");
  return 0.0;
}

std::optional<double> FieldReader::optional_number(const char* key) {
  return find(key) == nullptr ? std::nullopt : std::optional(number(key));
}

bool FieldReader::boolean(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return false;
  if (value->is_boolean()) return value->get<bool>();
  fault(key, "not a truth value", "true or false");
  return false;
}

Position FieldReader::position(const char* key) {
  std::vector<double> numbers;
  take(key, numbers);
  return position(key, numbers);
}

Position FieldReader::position(const char* key, const std::vector<double>& numbers) {
  if (numbers.size() == 3) return {numbers[0], numbers[1], numbers[2]};
  fault(key, "not a position", "[x, y, z] in metres");
  return {};
}

std::optional<Position> FieldReader::point(const char* key, const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  if (numbers.size() == 2) return Position{numbers[0], numbers[1], 0};
  fault(key, "not a point", "[x, y] in metres");
  return std::nullopt;
}

std::vector<Position> FieldReader::positions(const char* key, const std::vector<double>& numbers) {
  std::vector<Position> positions;
  if (numbers.size() % 3 != 0) fault(key, "not positions", "[x, y, z, …] in metres");
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    positions.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return positions;
}

std::size_t FieldReader::one_of(const char* key, const std::string& text,
                                std::span<const std::string_view> names) {
  const auto it = std::find(names.begin(), names.end(), text);
  if (it != names.end()) return static_cast<std::size_t>(it - names.begin());
  std::string expected;
  for (const std::string_view n : names)
    expected += (expected.empty() ? "" : ", ") + std::string(n);
  fault(key, "unknown value '" + text.substr(0, 80) + "'", expected,
        nearest_name(text.substr(0, 80), {names.begin(), names.end()}));
  return 0;
}

std::string FieldReader::rest() const {
  nlohmann::json left = nlohmann::json::object();
  if (object_.size() <= asked_.size()) {
    const auto asked = [this](const auto& key) {
      return std::find(asked_.begin(), asked_.end(), key) != asked_.end();
    };
    bool all = true;
    for (auto it = object_.begin(); all && it != object_.end(); ++it) all = asked(it.key());
    if (all) return {};
  }
  for (auto it = object_.begin(); it != object_.end(); ++it) {
    if (std::find(asked_.begin(), asked_.end(), it.key()) == asked_.end()) left[it.key()] = *it;
  }
  return left.empty() ? std::string() : safe_dump(left);
}

std::string safe_dump(const nlohmann::json& value, int indent) {
  return value.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::size_t nesting(std::string_view json) {
  std::size_t depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return deepest;
}

std::optional<nlohmann::json> parse_json(std::string_view text, Diagnostic where,
                                         Diagnostics& faults) {
  if (nesting(text) > kDeepest) {
    where.message = "nested too deeply";
    where.expected = "at most " + std::to_string(kDeepest) + " levels";
    faults.add(std::move(where));
    return std::nullopt;
  }
  nlohmann::json value = nlohmann::json::parse(text, nullptr, false);
  if (!value.is_discarded()) return value;
  where.message = "not valid JSON";
  faults.add(std::move(where));
  return std::nullopt;
}

}  // namespace skein::report
