// SPDX-License-Identifier: Apache-2.0
#include "channels.hpp"

#include <nlohmann/json.hpp>

#include "skein/foundation/overloaded.hpp"

namespace skein::foxglove {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostChannels = 60'000;  ///< a file has room for few more

Json typed(const char* type) { return {{"type", type}}; }

Json object_of(const Json& properties) { return {{"type", "object"}, {"properties", properties}}; }

Json numbers_of(std::initializer_list<const char*> names) {
  Json properties = Json::object();
  for (const char* name : names) properties[name] = typed("number");
  return object_of(properties);
}

Json time_schema() { return object_of({{"sec", typed("integer")}, {"nsec", typed("integer")}}); }

Json list_of(const char* type) { return {{"type", "array"}, {"items", typed(type)}}; }

std::string location_schema() {
  return object_of({{"timestamp", time_schema()},
                    {"frame_id", typed("string")},
                    {"latitude", typed("number")},
                    {"longitude", typed("number")},
                    {"altitude", typed("number")},
                    {"position_covariance", list_of("number")},
                    {"position_covariance_type", typed("integer")},
                    {"heading", typed("number")},
                    {"velocity", numbers_of({"x", "y", "z"})},
                    {"color", numbers_of({"r", "g", "b", "a"})}})
      .dump();
}

std::string log_schema() {
  return object_of({{"timestamp", time_schema()},
                    {"level", typed("integer")},
                    {"message", typed("string")},
                    {"name", typed("string")},
                    {"file", typed("string")},
                    {"line", typed("integer")}})
      .dump();
}

Json schema_of_value(const journal::Value& value) {
  return std::visit(Overloaded{[](bool) { return typed("boolean"); },
                               [](std::int64_t) { return typed("number"); },
                               [](double) { return typed("number"); },
                               [](const std::string&) { return typed("string"); },
                               [](const std::vector<double>&) { return list_of("number"); }},
                    value);
}

/// A JSON schema for each kind: of the fields that any record of it has.
std::map<std::string, std::string> schemas_of(const std::vector<journal::Record>& records) {
  std::map<std::string, Json> kinds;
  for (const journal::Record& record : records) {
    Json& properties = kinds[record.kind()];
    if (properties.is_null())
      properties = {{"at", typed("number")}, {"node", typed("string")}, {"kind", typed("string")}};
    for (const auto& [key, value] : record.fields())
      if (!properties.contains(key)) properties[key] = schema_of_value(value);
  }
  std::map<std::string, std::string> texts;
  for (const auto& [kind, properties] : kinds)
    texts["skein." + kind] =
        object_of(properties).dump(-1, ' ', false, Json::error_handler_t::replace);
  return texts;
}

}  // namespace

std::string timestamp_json(std::uint64_t time) {
  return "{\"sec\":" + std::to_string(time / 1'000'000'000) +
         ",\"nsec\":" + std::to_string(time % 1'000'000'000) + "}";
}

Channels::Channels(const std::vector<journal::Record>& records, mcap::Writer& writer)
    : writer_(writer), texts_(schemas_of(records)) {
  texts_["foxglove.LocationFix"] = location_schema();
  texts_["foxglove.Log"] = log_schema();
  texts_["foxglove.GeoJSON"] = object_of({{"geojson", typed("string")}}).dump();
}

void Channels::geojson(const std::string& topic, std::uint64_t time, const std::string& geojson) {
  put(topic, "foxglove.GeoJSON", time, Json{{"geojson", geojson}}.dump());
}

void Channels::record(std::uint64_t time, const journal::Record& record) {
  const std::string_view uav = record.text("uav");
  put("/" + (uav.empty() ? record.node() : std::string(uav)) + "/" + record.kind(),
      "skein." + record.kind(), time, journal::to_json(record));
}

void Channels::put(const std::string& topic, const std::string& schema, std::uint64_t time,
                   const std::string& json) {
  auto channel = channels_.find(topic);
  if (channel == channels_.end()) {
    if (channels_.size() == kMostChannels) return;  // names of a log that nobody wrote in earnest
    const mcap::ChannelId id = writer_.add(mcap::Channel{schema_of(schema), topic, "json"});
    channel = channels_.emplace(topic, id).first;
  }
  writer_.write(channel->second, time, json);
}

mcap::SchemaId Channels::schema_of(const std::string& name) {
  auto schema = schemas_.find(name);
  if (schema == schemas_.end()) {
    const mcap::SchemaId id = writer_.add(mcap::Schema{name, "jsonschema", texts_[name]});
    schema = schemas_.emplace(name, id).first;
  }
  return schema->second;
}

}  // namespace skein::foxglove
