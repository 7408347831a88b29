// SPDX-License-Identifier: Apache-2.0
#include "json.hpp"

#include "skein/config/parse.hpp"

namespace skein::designer {

namespace {

using config::Value;

constexpr const char* kQuoted = "\"";

std::optional<yaml_edit::Path> path_of(const Json& json) {
  if (!json.is_array()) return std::nullopt;
  yaml_edit::Path path;
  for (const Json& step : json) {
    if (step.is_string()) {
      path.emplace_back(step.get<std::string>());
    } else if (step.is_number_unsigned()) {
      path.emplace_back(step.get<std::size_t>());
    } else {
      return std::nullopt;
    }
  }
  return path;
}

std::size_t index_in(const Json& json) {
  const bool said = json.contains("index") && json["index"].is_number_unsigned();
  return said ? json["index"].get<std::size_t>() : static_cast<std::size_t>(-1);
}

std::string key_in(const Json& json) {
  return json.contains("key") && json["key"].is_string() ? json["key"].get<std::string>() : "";
}

/// As "value", or as YAML that somebody typed.
Result<Value, Failure> value_in(const Json& json) {
  if (json.contains("value")) return value_of(json["value"]);
  if (!json.contains("yaml") || !json["yaml"].is_string()) return failure("value: expected one");
  const auto read = config::parse_yaml(json["yaml"].get<std::string>(), "");
  if (!read) return failure("that is no YAML: " + read.error().all().front().message);
  return *read;
}

Value scalar(std::string text, bool quoted) {
  Value value;
  value.kind = Value::Kind::kScalar;
  value.scalar = std::move(text);
  value.quoted = quoted;
  return value;
}

}  // namespace

Json to_json(const Value& value) {
  switch (value.kind) {
    case Value::Kind::kNull:
      return nullptr;
    case Value::Kind::kScalar:
      if (value.quoted) return Json{{kQuoted, value.scalar}};
      return value.scalar;
    case Value::Kind::kSequence: {
      Json list = Json::array();
      for (const Value& item : value.items) list.push_back(to_json(item));
      return list;
    }
    case Value::Kind::kMap:
      break;
  }
  Json map = Json::object();
  for (const auto& [key, one] : value.entries) map[key] = to_json(one);
  return map;
}

Value value_of(const Json& json) {
  if (json.is_string()) return scalar(json.get<std::string>(), false);
  if (json.is_number() || json.is_boolean()) return scalar(json.dump(), false);
  Value value;
  if (json.is_array()) {
    value.kind = Value::Kind::kSequence;
    for (const Json& item : json) value.items.push_back(value_of(item));
  } else if (json.is_object()) {
    if (json.size() == 1 && json.contains(kQuoted) && json[kQuoted].is_string()) {
      return scalar(json[kQuoted].get<std::string>(), true);
    }
    value.kind = Value::Kind::kMap;
    for (const auto& [key, one] : json.items()) value.entries.push_back({key, value_of(one)});
  }
  return value;
}

Result<yaml_edit::Edit, Failure> edit_of(const Json& json) {
  for (const char* verb : {"set", "insert", "remove", "rename", "move"}) {
    if (!json.is_object() || !json.contains(verb)) continue;
    const auto path = path_of(json[verb]);
    if (!path) return failure(std::string(verb) + ": expected a path");
    const std::string what = verb;
    if (what == "remove") return yaml_edit::Remove{*path};
    if (what == "rename") return yaml_edit::Rename{*path, key_in(json)};
    if (what == "move") {
      const auto into = json.contains("into") ? path_of(json["into"]) : std::nullopt;
      if (!into) return failure("into: expected a path");
      return yaml_edit::Move{*path, *into, index_in(json)};
    }
    auto value = value_in(json);
    if (!value) return tl::unexpected(value.error());
    if (what == "set") return yaml_edit::Set{*path, std::move(*value)};
    return yaml_edit::Insert{*path, index_in(json), key_in(json), std::move(*value)};
  }
  return failure("expected an edit");
}

}  // namespace skein::designer
