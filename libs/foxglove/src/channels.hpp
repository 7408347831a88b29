// SPDX-License-Identifier: Apache-2.0
// The channels of an exported run, made when they are first needed.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/mcap/writer.hpp"

namespace skein::foxglove {

class Channels {
 public:
  /// The records are looked through for the fields of each kind. The writer outlives this.
  Channels(const std::vector<journal::Record>& records, mcap::Writer& writer);

  void location(const std::string& topic, std::uint64_t time, const std::string& json) {
    put(topic, "foxglove.LocationFix", time, json);
  }
  void geojson(const std::string& topic, std::uint64_t time, const std::string& geojson);
  void log(const std::string& topic, std::uint64_t time, const std::string& json) {
    put(topic, "foxglove.Log", time, json);
  }
  /// As it is, under the UAV or node that it is of.
  void record(std::uint64_t time, const journal::Record& record);

 private:
  void put(const std::string& topic, const std::string& schema, std::uint64_t time,
           const std::string& json);
  mcap::SchemaId schema_of(const std::string& name);

  mcap::Writer& writer_;
  std::map<std::string, std::string> texts_;  ///< JSON schemas by name
  std::map<std::string, mcap::SchemaId> schemas_;
  std::map<std::string, mcap::ChannelId> channels_;
};

/// "{"sec":…,"nsec":…}".
std::string timestamp_json(std::uint64_t time);

}  // namespace skein::foxglove
