// SPDX-License-Identifier: Apache-2.0
// All slots, in their order: states, events, streams; in each class as in its IDL.
// Written by idl/generate_wire.py from idl/*.idl: change that, and run it.
// clang-format off
#pragma once

#include <array>
#include <cstdint>
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
using SampleVariant = std::variant<DirectoryEntry, Clock, LinkState, PlanBoard, AutonomyDegree,
    MissionState, MissionPlan, JointTaskState, PlanFrontier, UavBoard, UavTasks, GroundBoard,
    SeenObject, Neighbours, TaskRequest, RequestReply, TaskEvent, FunctionalRequest,
    FunctionalStatus, SyncMessage, Sighting, Alarm, MissionRequest, DegreeCommand, WorldChange,
    MissionOutcome, HandOver, Decision, NegotiationMessage, TeamMessage, TeamSale, MergeMessage,
    OperatorRequest, OperatorReply, JournalEntry, Telemetry, PerceptionReport, Truth, Heartbeat,
    Part>;

/// A SampleVariant whose copies, moves and end are compiled once (wire.cpp), not wherever one is kept.
class Sample : public SampleVariant {
 public:
  using SampleVariant::SampleVariant;
  using SampleVariant::operator=;
  Sample();
  Sample(const Sample& other);
  Sample(Sample&& other) noexcept;
  Sample& operator=(const Sample& other);
  Sample& operator=(Sample&& other) noexcept;
  ~Sample();
};

enum class Slot : std::uint8_t {kDirectoryEntry, kClock, kLinkState, kPlanBoard, kAutonomyDegree,
    kMissionState, kMissionPlan, kJointTaskState, kPlanFrontier, kUavBoard, kUavTasks, kGroundBoard,
    kSeenObject, kNeighbours, kTaskRequest, kRequestReply, kTaskEvent, kFunctionalRequest,
    kFunctionalStatus, kSyncMessage, kSighting, kAlarm, kMissionRequest, kDegreeCommand,
    kWorldChange, kMissionOutcome, kHandOver, kDecision, kNegotiationMessage, kTeamMessage,
    kTeamSale, kMergeMessage, kOperatorRequest, kOperatorReply, kJournalEntry, kTelemetry,
    kPerceptionReport, kTruth, kHeartbeat, kPart};

/// By slot; also those of the IDL types and of the DDS topics.
inline constexpr auto kSlotNames = std::to_array<std::string_view>({"DirectoryEntry", "Clock",
    "LinkState", "PlanBoard", "AutonomyDegree", "MissionState", "MissionPlan", "JointTaskState",
    "PlanFrontier", "UavBoard", "UavTasks", "GroundBoard", "SeenObject", "Neighbours",
    "TaskRequest", "RequestReply", "TaskEvent", "FunctionalRequest", "FunctionalStatus",
    "SyncMessage", "Sighting", "Alarm", "MissionRequest", "DegreeCommand", "WorldChange",
    "MissionOutcome", "HandOver", "Decision", "NegotiationMessage", "TeamMessage", "TeamSale",
    "MergeMessage", "OperatorRequest", "OperatorReply", "JournalEntry", "Telemetry",
    "PerceptionReport", "Truth", "Heartbeat", "Part"});

/// Source: spec 1.3, the table of delivery classes.
enum class SlotClass : std::uint8_t { kState, kEvent, kStream };

constexpr SlotClass slot_class(Slot slot) {
  if (slot <= Slot::kNeighbours) return SlotClass::kState;
  return slot <= Slot::kJournalEntry ? SlotClass::kEvent : SlotClass::kStream;
}

/// `macro(Type)` for each slot.
#define SKEIN_FOR_EACH_SLOT(macro) macro(DirectoryEntry) macro(Clock) macro(LinkState) \
    macro(PlanBoard) macro(AutonomyDegree) macro(MissionState) macro(MissionPlan) \
    macro(JointTaskState) macro(PlanFrontier) macro(UavBoard) macro(UavTasks) macro(GroundBoard) \
    macro(SeenObject) macro(Neighbours) macro(TaskRequest) macro(RequestReply) macro(TaskEvent) \
    macro(FunctionalRequest) macro(FunctionalStatus) macro(SyncMessage) macro(Sighting) \
    macro(Alarm) macro(MissionRequest) macro(DegreeCommand) macro(WorldChange) \
    macro(MissionOutcome) macro(HandOver) macro(Decision) macro(NegotiationMessage) \
    macro(TeamMessage) macro(TeamSale) macro(MergeMessage) macro(OperatorRequest) \
    macro(OperatorReply) macro(JournalEntry) macro(Telemetry) macro(PerceptionReport) macro(Truth) \
    macro(Heartbeat) macro(Part)

}  // namespace skein::wire
