// SPDX-License-Identifier: Apache-2.0
// Records to and from JSON lines.
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "skein/foundation/shortest_text.hpp"
#include "skein/journal/record.hpp"

namespace skein::journal {

namespace {

using Json = nlohmann::ordered_json;

void append_text(std::string& line, const std::string& text) {
  line += Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void append_number(std::string& line, double x) {
  if (!std::isfinite(x)) {
    line += "null";
    return;
  }
  line += shortest_text(x);
}

void append_value(std::string& line, const Value& value) {
  if (const auto* truth = std::get_if<bool>(&value)) {
    line += *truth ? "true" : "false";
  } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    line += std::to_string(*whole);
  } else if (const auto* number = std::get_if<double>(&value)) {
    append_number(line, *number);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    append_text(line, *text);
  } else {
    line += '[';
    const auto& list = std::get<std::vector<double>>(value);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i > 0) line += ',';
      append_number(line, list[i]);
    }
    line += ']';
  }
}

// Doubles hold instants exactly to the nanosecond up to about a hundred days.
std::optional<MissionTime> instant_of(const Json& at) {
  if (!at.is_number() || !std::isfinite(at.get<double>())) return std::nullopt;
  return MissionTime::seconds(at.get<double>());
}

std::optional<Value> value_of(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX) return json.get<double>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number_float()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array()) return std::nullopt;
  std::vector<double> list;
  for (const Json& item : json) {
    if (!item.is_number()) return std::nullopt;
    list.push_back(item.get<double>());
  }
  return list;
}

}  // namespace

std::string to_json(const Record& record) {
  std::string line = "{\"at\":" + to_text(record.at()) + ",\"node\":";
  append_text(line, record.node());
  line += ",\"kind\":";
  append_text(line, record.kind());
  for (const auto& [key, value] : record.fields()) {
    line += ',';
    append_text(line, key);
    line += ':';
    append_value(line, value);
  }
  line += '}';
  return line;
}

Result<Record, Failure> parse_record(std::string_view line) {
  const Json json = Json::parse(line.begin(), line.end(), nullptr, false);
  if (!json.is_object()) return failure("not a JSON object");
  const auto at = json.contains("at") ? instant_of(json["at"]) : std::nullopt;
  if (!at) return failure("'at' is missing or not a number");
  for (const char* key : {"node", "kind"}) {
    if (!json.contains(key) || !json[key].is_string()) {
      return failure(std::string("'") + key + "' is missing or not text");
    }
  }
  Record record(*at, json["node"].get<std::string>(), json["kind"].get<std::string>());
  for (const auto& [key, item] : json.items()) {
    if (key == "at" || key == "node" || key == "kind") continue;
    if (auto value = value_of(item)) record.with(key, std::move(*value));
  }
  return record;
}

}  // namespace skein::journal
