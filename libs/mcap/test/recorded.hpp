// SPDX-License-Identifier: Apache-2.0
// Recordings of tests, and what is read of them.
#pragma once

#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "skein/mcap/scan.hpp"
#include "skein/mcap/writer.hpp"

namespace skein::mcap {

/// A message with the topic of its channel.
struct Told {
  std::string topic;
  std::uint64_t log_time = 0, publish_time = 0;
  std::string data;
  bool operator==(const Told&) const = default;
};

inline void showValue(const Told& told, std::ostream& out) {
  out << told.topic << '@' << told.log_time << ':' << told.data.size();
}

struct Read {
  Contents contents;
  std::vector<Told> messages;
};

inline Read read(std::string_view file, const ScanLimits& limits = {}) {
  Read read;
  read.contents = scan(
      file,
      [&](const Channel& channel, const Message& message) {
        read.messages.push_back(
            {channel.topic, message.log_time, message.publish_time, std::string(message.data)});
      },
      limits);
  return read;
}

/// A file with these messages; a schema and a channel for each topic, added when it first comes.
inline std::string written(const std::vector<Told>& messages, Compression compression,
                           std::size_t chunk = 200, bool closed = true) {
  std::string file;
  Writer writer({"test", "", compression, chunk},
                [&](std::string_view bytes) { file.append(bytes); });
  std::map<std::string, ChannelId> channels;
  for (const Told& one : messages) {
    auto [channel, fresh] = channels.try_emplace(one.topic, ChannelId{0});
    if (fresh) {
      const SchemaId schema = writer.add(Schema{one.topic + "Schema", "jsonschema", "{}"});
      channel->second = writer.add(Channel{schema, one.topic, "json", {{"of", one.topic}}});
    }
    writer.write(channel->second, one.log_time, one.publish_time, one.data);
  }
  if (closed) {
    writer.close();
  } else {
    writer.flush();
  }
  return file;
}

inline rc::Gen<Told> any_message() {
  return rc::gen::build<Told>(
      rc::gen::set(&Told::topic, rc::gen::element<std::string>("a", "b", "/c/d", "")),
      rc::gen::set(&Told::log_time), rc::gen::set(&Told::publish_time),
      rc::gen::set(&Told::data, rc::gen::container<std::string>(rc::gen::arbitrary<char>())));
}

inline rc::Gen<Compression> any_compression() {
  return rc::gen::element(Compression::kNone, Compression::kLz4, Compression::kZstd);
}

}  // namespace skein::mcap
