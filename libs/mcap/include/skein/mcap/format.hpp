// SPDX-License-Identifier: Apache-2.0
// What MCAP files are made of. Source: MCAP specification.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace skein::mcap {

using SchemaId = std::uint16_t;  ///< 0: none
using ChannelId = std::uint16_t;

struct Schema {
  std::string name;      ///< "foxglove.LocationFix"
  std::string encoding;  ///< "jsonschema", "omgidl"
  std::string data;
  bool operator==(const Schema&) const = default;
};

struct Channel {
  SchemaId schema = 0;
  std::string topic;
  std::string encoding;  ///< of messages: "json", "cdr"
  std::map<std::string, std::string> metadata = {};
  bool operator==(const Channel&) const = default;
};

struct Message {
  ChannelId channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0, publish_time = 0;  ///< [ns] since an epoch of the file's own
  std::string_view data;
  bool operator==(const Message&) const = default;
};

enum class Compression { kNone, kLz4, kZstd };

}  // namespace skein::mcap
