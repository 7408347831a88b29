// SPDX-License-Identifier: Apache-2.0
// What the kinds of channel carry and how their partitions are named.
#include "skein/blackboard/channel.hpp"

#include <array>

#include "skein/blackboard/cdr.hpp"

namespace skein::blackboard {
namespace {

using wire::Slot;

/// [byte]: IP and UDP 28, RTPS header 20, timestamp 12, destination 16, data 24.
constexpr std::size_t kFrame = 100;

// At degree 1 the ground station talks with the functional layer through the decision node.
std::vector<Slot> radio_slots() {
  return {Slot::kPlanBoard,        Slot::kAutonomyDegree,     Slot::kMissionState,
          Slot::kRequestReply,     Slot::kTaskEvent,          Slot::kFunctionalRequest,
          Slot::kFunctionalStatus, Slot::kSyncMessage,        Slot::kAlarm,
          Slot::kTelemetry,        Slot::kPerceptionReport,   Slot::kJointTaskState,
          Slot::kPlanFrontier,     Slot::kNegotiationMessage, Slot::kTeamMessage,
          Slot::kTeamSale,         Slot::kMergeMessage};
}

constexpr auto kFromStation = std::to_array<Slot>(
    {Slot::kTaskRequest, Slot::kMissionRequest, Slot::kDegreeCommand, Slot::kWorldChange});
constexpr auto kToStation = std::to_array<Slot>(
    {Slot::kMissionPlan, Slot::kMissionOutcome, Slot::kHandOver, Slot::kDecision});

std::vector<Slot> onboard_slots() {
  return {Slot::kFunctionalRequest, Slot::kFunctionalStatus, Slot::kTelemetry,
          Slot::kPerceptionReport};
}

std::vector<Slot> world_slots() {
  return {Slot::kDirectoryEntry, Slot::kClock,           Slot::kLinkState,    Slot::kMissionState,
          Slot::kJournalEntry,   Slot::kTruth,           Slot::kUavBoard,     Slot::kUavTasks,
          Slot::kGroundBoard,    Slot::kOperatorRequest, Slot::kOperatorReply};
}

}  // namespace

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
  const auto partition = [](const Node& from, const Node& to) {
    return "radio/" + from.name + ">" + to.name;
  };
  return {{a.number, b.number, ChannelKind::kRadio, partition(a, b), radio_slots()},
          {b.number, a.number, ChannelKind::kRadio, partition(b, a), radio_slots()}};
}

std::vector<ChannelConfig> station_link(const Node& station, const Node& uav) {
  std::vector<ChannelConfig> link = radio_link(station, uav);
  std::vector<Slot>& up = link[0].slots;
  std::vector<Slot>& down = link[1].slots;
  up.insert(up.end(), kFromStation.begin(), kFromStation.end());
  down.insert(down.end(), kToStation.begin(), kToStation.end());
  return link;
}

std::vector<ChannelConfig> onboard_link(const Node& uav, const Node& simulator) {
  const std::string partition = "onboard/" + uav.name;
  return {{uav.number, simulator.number, ChannelKind::kOnboard, partition, onboard_slots()},
          {simulator.number, uav.number, ChannelKind::kOnboard, partition, onboard_slots()}};
}

std::size_t channel_bytes(const wire::Sample& sample) { return kFrame + encoded_size(sample); }

std::size_t heartbeat_bytes() {
  static const std::size_t bytes = channel_bytes(wire::Heartbeat{});
  return bytes;
}

Duration airtime(std::size_t bytes, double capacity) {
  return Duration::seconds(8.0 * static_cast<double>(bytes) / capacity);
}

ChannelConfig world_channel() {
  return {kEverybody, kEverybody, ChannelKind::kWorld, "world", world_slots()};
}

}  // namespace skein::blackboard
