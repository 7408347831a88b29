// SPDX-License-Identifier: Apache-2.0
#include "bytes.hpp"

#include <zlib.h>

namespace skein::mcap {

Bytes& Bytes::put(const std::map<std::string, std::string>& map) {
  Bytes entries;
  for (const auto& [key, value] : map)
    entries.put(std::string_view(key)).put(std::string_view(value));
  return put(std::string_view(entries.text()));
}

std::string record(Op op, std::string_view content) {
  Bytes bytes;
  bytes.put(static_cast<std::uint8_t>(op)).put(static_cast<std::uint64_t>(content.size()));
  return bytes.raw(content).text();
}

std::string record_of(SchemaId id, const Schema& schema) {
  Bytes bytes;
  bytes.put(id)
      .put(std::string_view(schema.name))
      .put(std::string_view(schema.encoding))
      .put(std::string_view(schema.data));
  return record(Op::kSchema, bytes.text());
}

std::string record_of(ChannelId id, const Channel& channel) {
  Bytes bytes;
  bytes.put(id)
      .put(channel.schema)
      .put(std::string_view(channel.topic))
      .put(std::string_view(channel.encoding))
      .put(channel.metadata);
  return record(Op::kChannel, bytes.text());
}

std::map<std::string, std::string> Taker::map() {
  std::map<std::string, std::string> result;
  Taker entries(text());
  while (good_ && !entries.left().empty()) {
    const std::string key(entries.text());
    const std::string value(entries.text());
    good_ = entries.good();
    if (good_) result.emplace(key, value);
  }
  return result;
}

std::optional<std::pair<SchemaId, Schema>> schema_from(std::string_view content) {
  Taker taker(content);
  const auto id = taker.take<SchemaId>();
  Schema schema;
  schema.name = taker.text();
  schema.encoding = taker.text();
  schema.data = taker.text();
  if (!taker.good()) return std::nullopt;
  return std::pair(id, std::move(schema));
}

std::optional<std::pair<ChannelId, Channel>> channel_from(std::string_view content) {
  Taker taker(content);
  const auto id = taker.take<ChannelId>();
  Channel channel;
  channel.schema = taker.take<SchemaId>();
  channel.topic = taker.text();
  channel.encoding = taker.text();
  channel.metadata = taker.map();
  if (!taker.good()) return std::nullopt;
  return std::pair(id, std::move(channel));
}

std::optional<Message> message_from(std::string_view content) {
  Taker taker(content);
  Message message;
  message.channel = taker.take<ChannelId>();
  message.sequence = taker.take<std::uint32_t>();
  message.log_time = taker.take<std::uint64_t>();
  message.publish_time = taker.take<std::uint64_t>();
  message.data = taker.left();
  if (!taker.good()) return std::nullopt;
  return message;
}

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace skein::mcap
