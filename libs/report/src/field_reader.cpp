// SPDX-License-Identifier: Apache-2.0
#include "field_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "skein/foundation/nearest.hpp"

namespace skein::report {

namespace {
constexpr std::size_t kDeepest = 64;
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

std::uint64_t FieldReader::id(const char* key) {
  return require(key) == nullptr ? 0 : optional_id(key).value_or(0);
}

std::optional<std::uint64_t> FieldReader::optional_id(const char* key) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number_unsigned()) return value->get<std::uint64_t>();
  if (value->is_string()) {
    const auto& text = value->get_ref<const std::string&>();
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size()) return number;
  }
  fault(key, "not an identifier", "an unsigned 64-bit integer");
  return std::nullopt;
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

std::optional<double> FieldReader::optional_number(const char* key, double limit) {
  const nlohmann::json* value = find(key);
  if (value == nullptr || value->is_null()) return std::nullopt;
  return number(key, limit);
}

bool FieldReader::boolean(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return false;
  if (value->is_boolean()) return value->get<bool>();
  fault(key, "not a truth value", "true or false");
  return false;
}

Position FieldReader::position(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return {};
  const auto fits = [](const nlohmann::json& v) {
    return v.is_number() && std::abs(v.get<double>()) <= kLargestNumber;
  };
  if (value->is_array() && value->size() == 3 && std::all_of(value->begin(), value->end(), fits)) {
    return {(*value)[0].get<double>(), (*value)[1].get<double>(), (*value)[2].get<double>()};
  }
  fault(key, "not a position", "[x, y, z] in metres");
  return {};
}

std::optional<Position> FieldReader::optional_point(const char* key) {
  const nlohmann::json* value = find(key);
  if (value == nullptr || value->is_null()) return std::nullopt;
  const auto fits = [](const nlohmann::json& v) {
    return v.is_number() && std::abs(v.get<double>()) <= kLargestNumber;
  };
  if (value->is_array() && value->size() == 2 && std::all_of(value->begin(), value->end(), fits))
    return Position{(*value)[0].get<double>(), (*value)[1].get<double>(), 0};
  fault(key, "not a point", "[x, y] in metres");
  return std::nullopt;
}

std::vector<Position> FieldReader::optional_positions(const char* key) {
  const nlohmann::json* value = find(key);
  std::vector<Position> positions;
  if (value == nullptr || value->is_null()) return positions;
  const auto fits = [](const nlohmann::json& v) {
    return v.is_number() && std::abs(v.get<double>()) <= kLargestNumber;
  };
  const bool good = value->is_array() && value->size() % 3 == 0 &&
                    std::all_of(value->begin(), value->end(), fits);
  if (!good) {
    fault(key, "not positions", "[x, y, z, …] in metres");
    return positions;
  }
  for (std::size_t i = 0; i + 2 < value->size(); i += 3) {
    positions.push_back(
        {(*value)[i].get<double>(), (*value)[i + 1].get<double>(), (*value)[i + 2].get<double>()});
  }
  return positions;
}

std::int64_t FieldReader::count(const char* key) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return 0;
  if (value->is_array()) return static_cast<std::int64_t>(value->size());
  return integer(key);
}

std::size_t FieldReader::one_of(const char* key, std::span<const std::string_view> names) {
  const nlohmann::json* value = require(key);
  if (value == nullptr) return 0;
  const std::string text = value->is_string() ? value->get<std::string>() : safe_dump(*value);
  const auto it = std::find(names.begin(), names.end(), text);
  if (value->is_string() && it != names.end()) {
    return static_cast<std::size_t>(it - names.begin());
  }
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
