// SPDX-License-Identifier: Apache-2.0
#include "recorder.hpp"

#include <span>
#include <variant>

#include "idl_text.hpp"
#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/dds_type.hpp"

namespace skein::spy_tool {

namespace {

constexpr const char* kEncoding = "cdr";
constexpr const char* kSlot = "slot";
constexpr const char* kPartition = "partition";

}  // namespace

Recorder::Recorder(bool with_json, mcap::Writer::Sink sink)
    : with_json_(with_json), writer_({}, std::move(sink)) {}

const Recorder::Pair& Recorder::channels_of(const Taken& taken) {
  const auto [place, fresh] = channels_.try_emplace({taken.partition, taken.slot});
  if (!fresh) return place->second;
  const std::string slot(wire::slot_name(taken.slot));
  const std::string topic = taken.partition + "/" + slot;
  const std::map<std::string, std::string> metadata{{kSlot, slot}, {kPartition, taken.partition}};
  auto& schema = schemas_[taken.slot];
  if (schema == 0)
    schema = writer_.add(mcap::Schema{blackboard::dds_type_of(taken.slot), "omgidl", idl_of(slot)});
  place->second.cdr = writer_.add(mcap::Channel{schema, topic, kEncoding, metadata});
  if (!with_json_) return place->second;
  if (any_json_ == 0)
    any_json_ = writer_.add(mcap::Schema{"skein.Sample", "jsonschema", "{\"type\":\"object\"}"});
  place->second.json = writer_.add(mcap::Channel{any_json_, topic + "/json", "json"});
  return place->second;
}

void Recorder::take(const Taken& taken) {
  const Pair& channels = channels_of(taken);
  writer_.write(channels.cdr, taken.heard, taken.sent, taken.bytes);
  ++samples_;
  if (channels.json != 0) write_json(channels.json, taken);
}

void Recorder::write_json(mcap::ChannelId channel, const Taken& taken) {
  const auto content = blackboard::decode(
      taken.slot, {reinterpret_cast<const std::uint8_t*>(taken.bytes.data()), taken.bytes.size()});
  if (const auto* sample = std::get_if<wire::Sample>(&content))
    writer_.write(channel, taken.heard, taken.sent, wire::to_json(*sample));
}

mcap::Contents samples_of(std::string_view file, const std::function<void(Taken)>& use) {
  return mcap::scan(file, [&](const mcap::Channel& channel, const mcap::Message& message) {
    const auto name = channel.metadata.find(kSlot);
    const auto partition = channel.metadata.find(kPartition);
    if (channel.encoding != kEncoding || name == channel.metadata.end() ||
        partition == channel.metadata.end())
      return;
    const auto slot = wire::slot_from_name(name->second);
    if (!slot) return;
    use({*slot, partition->second, message.log_time, message.publish_time,
         std::string(message.data)});
  });
}

}  // namespace skein::spy_tool
