// SPDX-License-Identifier: Apache-2.0
// Names of slots and access to the header of any sample.
#include "skein/blackboard/wire.hpp"

#include <algorithm>

namespace skein::wire {
namespace {

constexpr auto kNames = std::to_array<std::string_view>({"DirectoryEntry",
                                                         "Clock",
                                                         "LinkState",
                                                         "PlanBoard",
                                                         "AutonomyDegree",
                                                         "MissionState",
                                                         "MissionPlan",
                                                         "JointTaskState",
                                                         "PlanFrontier",
                                                         "SeenObject",
                                                         "UavBoard",
                                                         "UavTasks",
                                                         "GroundBoard",
                                                         "Neighbours",
                                                         "TaskRequest",
                                                         "RequestReply",
                                                         "TaskEvent",
                                                         "FunctionalRequest",
                                                         "FunctionalStatus",
                                                         "SyncMessage",
                                                         "Alarm",
                                                         "MissionRequest",
                                                         "DegreeCommand",
                                                         "WorldChange",
                                                         "MissionOutcome",
                                                         "HandOver",
                                                         "Decision",
                                                         "NegotiationMessage",
                                                         "TeamMessage",
                                                         "TeamSale",
                                                         "MergeMessage",
                                                         "OperatorRequest",
                                                         "OperatorReply",
                                                         "JournalEntry",
                                                         "Telemetry",
                                                         "PerceptionReport",
                                                         "Truth",
                                                         "Heartbeat"});
static_assert(kNames.size() == kSlotCount);

}  // namespace

std::string_view slot_name(Slot slot) { return kNames[static_cast<std::size_t>(slot)]; }

std::optional<Slot> slot_from_name(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Slot>(found - kNames.begin());
}

SampleHeader& header_of(Sample& sample) {
  return std::visit([](auto& value) -> SampleHeader& { return value.header; }, sample);
}

const SampleHeader& header_of(const Sample& sample) {
  return std::visit([](const auto& value) -> const SampleHeader& { return value.header; }, sample);
}

}  // namespace skein::wire
