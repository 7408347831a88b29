// SPDX-License-Identifier: Apache-2.0
// What the kinds of channel carry and how their partitions are named.
#include "skein/blackboard/channel.hpp"

#include <algorithm>
#include <utility>

#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/slot_table.hpp"

namespace skein::blackboard {
namespace {

using wire::Slot;

/// [byte]: IP and UDP 28, RTPS header 20, timestamp 12, destination 16, data 24.
constexpr std::size_t kFrame = 100;

/// Whom a node hears is told only where there are relays (add_relayed).
ChannelConfig radio(const Node& from, const Node& to, std::vector<Slot> slots) {
  std::erase(slots, Slot::kNeighbours);
  return {from.number, to.number, ChannelKind::kRadio, "radio/" + from.name + ">" + to.name,
          std::move(slots)};
}

bool contains(const std::vector<Slot>& slots, Slot slot) {
  return std::ranges::find(slots, slot) != slots.end();
}

}  // namespace

bool ChannelConfig::carries(Slot slot) const { return contains(slots, slot); }

bool ChannelConfig::relays(Slot slot) const { return contains(relayed, slot); }

bool ChannelConfig::originates(Slot slot) const {
  return (slot == Slot::kHeartbeat || carries(slot)) && !contains(passing, slot);
}

std::string_view name_of(ChannelKind kind) {
  switch (kind) {
    case ChannelKind::kRadio:
      return "radio";
    case ChannelKind::kOnboard:
      return "onboard";
    case ChannelKind::kWorld:
      return "world";
  }
  return "?";
}

std::vector<ChannelConfig> radio_link(const Node& a, const Node& b) {
  return radio_link(a, b, SlotTable::shipped());
}

std::vector<ChannelConfig> radio_link(const Node& a, const Node& b, const SlotTable& table) {
  return {radio(a, b, table.between(Party::kUav, Party::kUav)),
          radio(b, a, table.between(Party::kUav, Party::kUav))};
}

std::vector<ChannelConfig> station_link(const Node& station, const Node& uav) {
  return station_link(station, uav, SlotTable::shipped());
}

std::vector<ChannelConfig> station_link(const Node& station, const Node& uav,
                                        const SlotTable& table) {
  return {radio(station, uav, table.between(Party::kGround, Party::kUav)),
          radio(uav, station, table.between(Party::kUav, Party::kGround))};
}

std::vector<ChannelConfig> onboard_link(const Node& uav, const Node& simulator) {
  return onboard_link(uav, simulator, SlotTable::shipped());
}

std::vector<ChannelConfig> onboard_link(const Node& uav, const Node& simulator,
                                        const SlotTable& table) {
  const std::string partition = "onboard/" + uav.name;
  return {{uav.number, simulator.number, ChannelKind::kOnboard, partition,
           table.between(Party::kUav, Party::kFunctional)},
          {simulator.number, uav.number, ChannelKind::kOnboard, partition,
           table.between(Party::kFunctional, Party::kUav)}};
}

ChannelConfig world_channel() {
  return {kEverybody, kEverybody, ChannelKind::kWorld, "world", SlotTable::shipped().of_world()};
}

std::size_t channel_bytes(const wire::Sample& sample) { return kFrame + encoded_size(sample); }

std::size_t heartbeat_bytes() {
  static const std::size_t bytes = channel_bytes(wire::Heartbeat{});
  return bytes;
}

Duration airtime(std::size_t bytes, double capacity) {
  return Duration::seconds(8.0 * static_cast<double>(bytes) / capacity);
}

void add_relayed(ChannelConfig& channel, const RelayEnds& ends) {
  add_relayed(channel, ends, SlotTable::shipped());
}

// To the first relay goes what the sender has for anybody, from the last one what anybody has for
// the receiver, between relays everything; as far as relays pass it on.
void add_relayed(ChannelConfig& channel, const RelayEnds& ends, const SlotTable& table) {
  const auto add_to = [](std::vector<Slot>& slots, const std::vector<Slot>& more) {
    for (const Slot slot : more)
      if (!contains(slots, slot)) slots.push_back(slot);
  };
  const auto for_any = [&](Party from, bool is_station) {
    std::vector<Slot> all = table.between(from, Party::kUav);
    if (!is_station) add_to(all, table.between(from, Party::kGround));
    return all;
  };
  const std::vector<Slot> passed_on = table.relayed();
  std::vector<Slot> passing;
  if (ends.from) {
    const Party to = ends.to_station ? Party::kGround : Party::kUav;
    passing = table.between(Party::kUav, to);
    if (!ends.to_station) add_to(passing, table.between(Party::kGround, to));
    if (ends.to) passing = passed_on;
  } else if (ends.to) {
    passing = for_any(ends.from_station ? Party::kGround : Party::kUav, ends.from_station);
  }
  std::erase_if(passing,
                [&](Slot slot) { return !contains(passed_on, slot) || slot == Slot::kNeighbours; });
  if (ends.from) {
    channel.relayed = passing;
    add_to(channel.relayed, {Slot::kHeartbeat, Slot::kNeighbours});
  }
  std::erase_if(passing, [&](Slot slot) { return channel.carries(slot); });
  add_to(channel.slots, passing);
  add_to(channel.slots, {Slot::kNeighbours});
  channel.passing = std::move(passing);
}

}  // namespace skein::blackboard
