// SPDX-License-Identifier: Apache-2.0
// All slots of the blackboard, as one closed set.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "skein/blackboard/wire_event.hpp"
#include "skein/blackboard/wire_frontier.hpp"
#include "skein/blackboard/wire_merging.hpp"
#include "skein/blackboard/wire_neighbours.hpp"
#include "skein/blackboard/wire_objects.hpp"
#include "skein/blackboard/wire_state.hpp"
#include "skein/blackboard/wire_stream.hpp"
#include "skein/blackboard/wire_team.hpp"

namespace skein::wire {

/// The value of one slot. The order of the alternatives is the order of `Slot`.
using Sample =
    std::variant<DirectoryEntry, Clock, LinkState, PlanBoard, AutonomyDegree, MissionState,
                 MissionPlan, JointTaskState, PlanFrontier, SeenObject, UavBoard, UavTasks,
                 GroundBoard, Neighbours, TaskRequest, RequestReply, TaskEvent, FunctionalRequest,
                 FunctionalStatus, SyncMessage, Alarm, MissionRequest, DegreeCommand, WorldChange,
                 MissionOutcome, HandOver, Decision, NegotiationMessage, TeamMessage, TeamSale,
                 MergeMessage, OperatorRequest, OperatorReply, JournalEntry, Telemetry,
                 PerceptionReport, Truth, Heartbeat>;

enum class Slot : std::uint8_t {
  kDirectoryEntry,
  kClock,
  kLinkState,
  kPlanBoard,
  kAutonomyDegree,
  kMissionState,
  kMissionPlan,
  kJointTaskState,
  kPlanFrontier,
  kSeenObject,
  kUavBoard,
  kUavTasks,
  kGroundBoard,
  kNeighbours,
  kTaskRequest,
  kRequestReply,
  kTaskEvent,
  kFunctionalRequest,
  kFunctionalStatus,
  kSyncMessage,
  kAlarm,
  kMissionRequest,
  kDegreeCommand,
  kWorldChange,
  kMissionOutcome,
  kHandOver,
  kDecision,
  kNegotiationMessage,
  kTeamMessage,
  kTeamSale,
  kMergeMessage,
  kOperatorRequest,
  kOperatorReply,
  kJournalEntry,
  kTelemetry,
  kPerceptionReport,
  kTruth,
  kHeartbeat
};
inline constexpr std::size_t kSlotCount = std::variant_size_v<Sample>;

/// Source: spec 1.3, the table of delivery classes.
enum class SlotClass : std::uint8_t { kState, kEvent, kStream };

constexpr Slot slot_of(const Sample& sample) { return static_cast<Slot>(sample.index()); }

constexpr SlotClass slot_class(Slot slot) {
  if (slot <= Slot::kNeighbours) return SlotClass::kState;
  return slot <= Slot::kJournalEntry ? SlotClass::kEvent : SlotClass::kStream;
}

/// The name of the slot, which is that of its IDL type and of its DDS topic: "TaskRequest".
std::string_view slot_name(Slot slot);
std::optional<Slot> slot_from_name(std::string_view name);

SampleHeader& header_of(Sample& sample);
const SampleHeader& header_of(const Sample& sample);

/// Limits on what a peer may send; anything larger is malformed.
inline constexpr std::size_t kMaximumString = 65'536;  ///< [byte]
inline constexpr std::size_t kMaximumSequence = 4096;  ///< elements

/// The first field that breaks the rules of the wire.
struct Violation {
  std::string field;  ///< path: "task.preconditions[2].literals[0].state"
  std::string why;    ///< "7 is not a value of the enumeration"
  bool operator==(const Violation&) const = default;
};

/// Checks what holds for every wire type: enumerations in range, numbers finite, strings and
/// sequences within the limits. What a value means is for whoever converts it.
std::optional<Violation> find_violation(const Sample& sample);

/// One JSON object on one line: {"slot":"Clock","header":{…},…}; fields in wire order, enumerations
/// by name, times in ns.
std::string to_json(const Sample& sample);

/// One line for people: the slot, "origin>destination #sequence", then the fields but the header.
std::string to_text(const Sample& sample);

}  // namespace skein::wire
