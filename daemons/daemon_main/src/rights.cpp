// SPDX-License-Identifier: Apache-2.0
#include "rights.hpp"

namespace skein::daemon_main {

namespace {

using blackboard::ChannelConfig;
using blackboard::ChannelKind;

std::string lines(const std::string& node, const char* verb, const std::string& partition,
                  const std::vector<wire::Slot>& slots) {
  std::string text;
  for (const wire::Slot slot : slots) {
    text += node + " " + verb + " " + partition + " " + std::string(wire::slot_name(slot)) + "\n";
  }
  return text;
}

std::string lines_of(const node::Roster& roster, const node::Member& member,
                     const ChannelConfig& channel) {
  if (channel.kind == ChannelKind::kWorld) {
    return lines(member.name, "publish", channel.partition, channel.slots) +
           lines(member.name, "subscribe", channel.partition, roster.world_reads_of(member.role));
  }
  std::vector<wire::Slot> slots = channel.slots;
  slots.push_back(wire::Slot::kHeartbeat);
  const bool writes = channel.from == member.number;
  return lines(member.name, writes ? "publish" : "subscribe", channel.partition, slots);
}

std::string lines_of_spy() {
  std::vector<wire::Slot> all;
  for (std::size_t i = 0; i < wire::kSlotCount; ++i) all.push_back(static_cast<wire::Slot>(i));
  std::string text;
  for (const char* partition : {"world", "onboard/*", "radio/*"}) {
    text += lines("spy", "subscribe", partition, all);
  }
  return text;
}

}  // namespace

std::string rights_of(const node::Roster& roster) {
  std::string text;
  for (const node::Member& member : roster.members()) {
    for (const ChannelConfig& channel : roster.channels_of(member)) {
      text += lines_of(roster, member, channel);
    }
  }
  return text + lines_of_spy();
}

}  // namespace skein::daemon_main
