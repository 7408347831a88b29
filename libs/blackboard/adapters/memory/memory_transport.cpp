// SPDX-License-Identifier: Apache-2.0
// Delivery between the transports of one MemoryHub.
#include "skein/blackboard/memory_transport.hpp"

#include <fnmatch.h>

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

/// Partitions match as in DDS: one of the two may be a pattern.
bool partitions_match(const std::string& writer, const std::string& reader) {
  return writer == reader || fnmatch(reader.c_str(), writer.c_str(), 0) == 0;
}

}  // namespace

void MemoryHub::inject(const std::string& partition,
                       const std::variant<wire::Sample, Malformed>& content) {
  for (MemoryTransport* node : nodes_) {
    for (std::size_t i = 0; i < node->channels_.size(); ++i) {
      const auto& channel = node->channels_[i];
      if (channel.reads && channel.up && partitions_match(partition, channel.config.partition)) {
        node->put(i, content);
      }
    }
  }
}

MemoryTransport::~MemoryTransport() { std::erase(hub_.nodes_, this); }

Result<void, Failure> MemoryTransport::open(const TransportPlan& plan) {
  SKEIN_EXPECTS(channels_.empty());
  for (const ChannelConfig& config : plan.channels) {
    Channel channel;
    channel.config = config;
    const bool world = config.kind == ChannelKind::kWorld;
    channel.writes = world || config.from == plan.self;
    channel.reads = world || config.from != plan.self;
    channel.read_slots = world ? plan.world_reads : config.slots;
    if (!world) channel.read_slots.push_back(wire::Slot::kHeartbeat);
    channels_.push_back(std::move(channel));
  }
  for (MemoryTransport* node : hub_.nodes_) {
    for (const Channel& writer : node->channels_) {
      for (std::size_t i = 0; i < channels_.size(); ++i) replay(writer, *this, i);
    }
  }
  hub_.nodes_.push_back(this);
  return {};
}

bool MemoryTransport::write(std::size_t channel, const wire::Sample& sample) {
  Channel& writer = channels_.at(channel);
  SKEIN_EXPECTS(writer.writes);
  remember(writer, sample);
  if (!writer.up) return true;
  for (MemoryTransport* node : hub_.nodes_) {
    if (node != this) node->offer(writer.config.partition, sample);
  }
  return true;
}

void MemoryTransport::remember(Channel& channel, const wire::Sample& sample) const {
  const wire::Slot slot = wire::slot_of(sample);
  switch (wire::slot_class(slot)) {
    case wire::SlotClass::kState:
      channel.states.insert_or_assign({slot, wire::header_of(sample).instance}, sample);
      return;
    case wire::SlotClass::kEvent: {
      const bool world = channel.config.kind == ChannelKind::kWorld;
      channel.events.push_back(sample);
      if (channel.events.size() > (world ? kWorldEventDepth : kEventDepth)) {
        channel.events.pop_front();
      }
      return;
    }
    case wire::SlotClass::kStream:
      return;
  }
}

void MemoryTransport::offer(const std::string& partition, const wire::Sample& sample) {
  const wire::Slot slot = wire::slot_of(sample);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const Channel& reader = channels_[i];
    if (!reader.reads || !reader.up) continue;
    if (!partitions_match(partition, reader.config.partition)) continue;
    if (std::ranges::find(reader.read_slots, slot) != reader.read_slots.end()) put(i, sample);
  }
}

void MemoryTransport::put(std::size_t channel, std::variant<wire::Sample, Malformed> content) {
  mailbox_.push_back({channel, std::move(content)});
  if (notify_) notify_();
}

void MemoryTransport::replay(const Channel& writer, MemoryTransport& node, std::size_t reader) {
  const Channel& to = node.channels_[reader];
  if (!writer.writes || !writer.up || !to.reads || !to.up) return;
  if (!partitions_match(writer.config.partition, to.config.partition)) return;
  const auto wanted = [&](wire::Slot slot) {
    return std::ranges::find(to.read_slots, slot) != to.read_slots.end();
  };
  for (const auto& [key, state] : writer.states) {
    if (wanted(key.first)) node.put(reader, state);
  }
  for (const wire::Sample& event : writer.events) {
    if (wanted(wire::slot_of(event))) node.put(reader, event);
  }
}

void MemoryTransport::set_up(std::size_t channel, bool up) {
  Channel& mine = channels_.at(channel);
  if (mine.up == up) return;
  mine.up = up;
  if (!up) return;
  for (MemoryTransport* node : hub_.nodes_) {
    if (node == this) continue;
    for (std::size_t i = 0; i < node->channels_.size(); ++i) {
      replay(mine, *node, i);
      replay(node->channels_[i], *this, channel);
    }
  }
}

std::vector<Arrival> MemoryTransport::take() { return std::exchange(mailbox_, {}); }

}  // namespace skein::blackboard
