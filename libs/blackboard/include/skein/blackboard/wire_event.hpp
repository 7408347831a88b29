// SPDX-License-Identifier: Apache-2.0
// Slots of class event: handled exactly once and in order.
// Written by idl/generate_wire.py from idl/event.idl: change that, and run it.
// clang-format off
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

enum class RequestKind : std::uint32_t {
  kStart,
  kAbort,
  kProcessMessage,
  kUpdateConditions,
  kSuppress,
  kMission,
  kCancel,
  kDegree,
  kWorld,
  kCount
};
constexpr auto names_of(RequestKind) {
  return std::to_array<std::string_view>({"START", "ABORT", "PROCESS-MSG", "UPDATE-COND",
    "SUPPRESS", "MISSION", "CANCEL", "DEGREE", "WORLD"});
}

enum class InsertionMode : std::uint32_t {
  kSeq,
  kVut,
  kDep,
  kNut,
  kCount
};
constexpr auto names_of(InsertionMode) {
  return std::to_array<std::string_view>({"SEQ", "VUT", "DEP", "NUT"});
}

/// A request to an executive: the first five kinds. Which fields count follows from `kind`. Source:
/// spec 2.3.
struct TaskRequest {
  SampleHeader header;
  std::uint64_t command = 0;  ///< the sender's number for it, given back in the reply
  RequestKind kind = RequestKind::kStart;
  InsertionMode mode = InsertionMode::kSeq;  ///< kStart
  TaskSpec task;  ///< kStart
  std::uint64_t id = 0;  ///< kAbort, kUpdateConditions, kSuppress
  std::string message;  ///< kProcessMessage
  bool has_preconditions = false;  ///< kUpdateConditions: replace them
  bool has_exit_conditions = false;  ///< kUpdateConditions: replace them
  std::vector<Clause> preconditions;
  std::vector<Clause> exit_conditions;
  bool operator==(const TaskRequest&) const = default;
};
SKEIN_WIRE_FIELDS(TaskRequest, header, command, kind, mode, task, id, message, has_preconditions,
    has_exit_conditions, preconditions, exit_conditions)

/// The answer to a TaskRequest, MissionRequest, DegreeCommand or WorldChange.
struct RequestReply {
  SampleHeader header;
  std::uint64_t command = 0;
  RequestKind kind = RequestKind::kStart;
  std::uint64_t id = 0;  ///< of the task or the unit mission, where there is one
  bool accepted = false;
  std::string why;  ///< reasons of a refusal, separated by "; "
  bool operator==(const RequestReply&) const = default;
};
SKEIN_WIRE_FIELDS(RequestReply, header, command, kind, id, accepted, why)

/// Why a task was aborted, where somebody decides by it; the reason is for people.
enum class AbortCause : std::uint32_t {
  kOther,
  kRequested,
  kNoAir,
  kCount
};
constexpr auto names_of(AbortCause) {
  return std::to_array<std::string_view>({"other", "requested", "no-air"});
}

/// One transition of one task.
struct TaskEvent {
  SampleHeader header;
  std::string uav;
  std::uint64_t id = 0;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;
  AbortCause cause = AbortCause::kOther;
  std::int64_t at = 0;  ///< [ns] when it happened
  bool operator==(const TaskEvent&) const = default;
};
SKEIN_WIRE_FIELDS(TaskEvent, header, uav, id, type, state, reason, cause, at)

enum class FunctionalRequestKind : std::uint32_t {
  kDispatch,
  kInterrupt,
  kCount
};
constexpr auto names_of(FunctionalRequestKind) {
  return std::to_array<std::string_view>({"dispatch", "interrupt"});
}

/// From an executive to the functional layer of its UAV.
struct FunctionalRequest {
  SampleHeader header;
  std::string uav;
  FunctionalRequestKind kind = FunctionalRequestKind::kDispatch;
  std::uint64_t id = 0;
  std::string type;  ///< kDispatch
  std::vector<Parameter> parameters;  ///< kDispatch
  bool operator==(const FunctionalRequest&) const = default;
};
SKEIN_WIRE_FIELDS(FunctionalRequest, header, uav, kind, id, type, parameters)

/// What a functional layer says of a task: running, ended or aborted.
struct FunctionalStatus {
  SampleHeader header;
  std::string uav;
  std::uint64_t id = 0;
  TaskState state = TaskState::kRunning;
  std::string reason;
  AbortCause cause = AbortCause::kOther;  ///< kOther, unless a decision node says it itself
  bool operator==(const FunctionalStatus&) const = default;
};
SKEIN_WIRE_FIELDS(FunctionalStatus, header, uav, id, state, reason, cause)

enum class SyncWord : std::uint32_t {
  kThere,
  kDone,
  kWithdrawn,
  kCount
};
constexpr auto names_of(SyncWord) {
  return std::to_array<std::string_view>({"there", "done", "withdrawn"});
}

/// Source: spec 2.6.
struct SyncMessage {
  SampleHeader header;
  std::uint64_t id = 0;  ///< of the synchronisation
  std::string from;
  std::string to;  ///< the UAV it is for, also when the ground relays it
  SyncWord word = SyncWord::kThere;
  std::int64_t said = 0;  ///< when `from` said so [ns], also when the ground relays it
  bool operator==(const SyncMessage&) const = default;
};
SKEIN_WIRE_FIELDS(SyncMessage, header, id, from, to, word, said)

/// One look that found something, to the ground station: the evidence of an alarm must not be lost
/// as a PerceptionReport may be. Of a device that goes on finding things only so many looks are
/// events. Source: decision 46.
struct Sighting {
  SampleHeader header;
  std::string uav;
  std::string device;
  FloatVector3 viewpoint;
  FloatVector3 view_direction;  ///< unit vector
  float range = 0;  ///< [m]
  float aperture = 0;  ///< [rad] half angle of the cone of view
  std::vector<Detection> detections;
  bool operator==(const Sighting&) const = default;
};
SKEIN_WIRE_FIELDS(Sighting, header, uav, device, viewpoint, view_direction, range, aperture,
    detections)

struct Alarm {
  SampleHeader header;
  std::uint32_t id = 0;
  AlarmState state = AlarmState::kRaised;
  Vector3 position;
  double radius = 0;  ///< [m]
  double belief = 0;  ///< in [0, 1]
  std::int64_t seen = kNever;  ///< [ns], last; kNever: it does not age
  bool operator==(const Alarm&) const = default;
};
SKEIN_WIRE_FIELDS(Alarm, header, id, state, position, radius, belief, seen)

enum class MissionPlacement : std::uint32_t {
  kBest,
  kLast,
  kInTime,
  kTour,
  kFirst,
  kCount
};
constexpr auto names_of(MissionPlacement) {
  return std::to_array<std::string_view>({"best", "last", "in-time", "tour", "first"});
}

/// A unit mission for a UAV at degree 4; with `cancel`, a request to cancel high-level tasks.
/// Source: spec 6.2 (0), (2).
struct MissionRequest {
  SampleHeader header;
  std::uint64_t command = 0;  ///< the sender's number for it, given back in the reply
  bool cancel = false;
  std::uint64_t unit_mission = 0;  ///< its id; with `cancel`: all its tasks; 0: see `goals`
  MissionPlacement placement = MissionPlacement::kBest;
  bool interrupt = false;  ///< with PLACEMENT_FIRST: running tasks are interrupted, later resumed
  bool evaluate = false;  ///< only the cost is asked for: the plan is not adopted
  bool achieve_any = false;  ///< tasks without a plan are left out; false: all tasks or none
  std::string asked_by;
  std::vector<MissionTask> tasks;  ///< in the preferred order; with `cancel`: empty
  std::vector<std::uint64_t> goals;  ///< with `cancel`: ids of tasks; empty, and no mission: all
  bool operator==(const MissionRequest&) const = default;
};
SKEIN_WIRE_FIELDS(MissionRequest, header, command, cancel, unit_mission, placement, interrupt,
    evaluate, achieve_any, asked_by, tasks, goals)

/// The degree of autonomy that a UAV is to have from now on. Source: spec 1.2.
struct DegreeCommand {
  SampleHeader header;
  std::uint64_t command = 0;
  std::uint8_t degree = 0;
  bool interrupt = false;  ///< what runs is interrupted and the UAV waits
  bool resume = false;  ///< up to 4: go on with what was handed over
  std::string asked_by;
  bool operator==(const DegreeCommand&) const = default;
};
SKEIN_WIRE_FIELDS(DegreeCommand, header, command, degree, interrupt, resume, asked_by)

/// Change of the world model: WORLD_AIR: closed air (name to until); WORLD_PLACE: a named place
/// (name, at, radius, cells); WORLD_GROUND: an area of ground (corners, risk, mapped, cells).
struct WorldChange {
  SampleHeader header;
  std::uint64_t command = 0;
  bool remove = false;  ///< the volume `name` is open again; no other field counts
  std::string name;
  std::vector<double> corners;  ///< [m] ENU; x, y of each corner of the polygon
  double floor = 0;  ///< [m] height; at or below -1e9: none
  double ceiling = 0;  ///< [m] height; at or above 1e9: none
  std::int64_t from = 0;  ///< [ns] mission time when the volume closes
  std::int64_t until = kNever;  ///< [ns] mission time when it opens
  WorldPart part = WorldPart::kAir;
  Vector3 at;  ///< [m] ENU; position of the place
  double radius = 0;  ///< [m] of the object at the place
  double risk = -1;  ///< risk of the ground in the area, in [0, 1]; below 0: unchanged
  bool mapped = false;  ///< the area has been mapped
  CellChange cells = CellChange::kAsBefore;  ///< new state of the cells there
  bool operator==(const WorldChange&) const = default;
};
SKEIN_WIRE_FIELDS(WorldChange, header, command, remove, name, corners, floor, ceiling, from, until,
    part, at, radius, risk, mapped, cells)

/// What became of a mission that was accepted for planning.
struct MissionOutcome {
  SampleHeader header;
  std::string uav;
  std::uint64_t unit_mission = 0;
  bool planned = false;
  std::vector<std::string> reasons;  ///< why it was not planned
  bool evaluated = false;  ///< only the cost was asked for: the plan was not adopted
  MissionPlacement placement = MissionPlacement::kBest;
  double cost = 0;  ///< added to the plan's cost
  double energy = 0;  ///< added to the plan's energy
  std::int64_t earliest_end = 0;  ///< [ns]
  std::int64_t latest_end = 0;  ///< [ns]
  std::int64_t plan_end = 0;  ///< [ns]
  bool operator==(const MissionOutcome&) const = default;
};
SKEIN_WIRE_FIELDS(MissionOutcome, header, uav, unit_mission, planned, reasons, evaluated, placement,
    cost, energy, earliest_end, latest_end, plan_end)

/// A task with its conditions and where it stands.
struct HeldTask {
  TaskSpec task;
  TaskState state = TaskState::kScheduled;
  bool in_executive = false;  ///< false: only planned
  std::uint64_t origin = 0;  ///< the high-level task it comes from; 0: none
  bool operator==(const HeldTask&) const = default;
};
SKEIN_WIRE_FIELDS(HeldTask, task, state, in_executive, origin)

/// The plan that a UAV holds when its degree changes.
struct HandOver {
  SampleHeader header;
  std::string uav;
  std::uint8_t degree = 0;  ///< from now on
  std::vector<HeldTask> tasks;  ///< by id
  std::vector<GoalEntry> goals;
  bool operator==(const HandOver&) const = default;
};
SKEIN_WIRE_FIELDS(HandOver, header, uav, degree, tasks, goals)

/// One application of an operator of the supervisor. Source: spec 6.2.
struct Decision {
  SampleHeader header;
  std::string uav;
  std::uint64_t number = 0;  ///< from 1 in one life of the node
  std::string applied;
  std::string cause;
  std::string inputs;
  std::string outcome;
  std::int64_t began = 0;  ///< [ns]
  std::int64_t took = 0;  ///< [ns] of mission time
  bool operator==(const Decision&) const = default;
};
SKEIN_WIRE_FIELDS(Decision, header, uav, number, applied, cause, inputs, outcome, began, took)

enum class NegotiationVow : std::uint32_t {
  kNone,
  kPromised,
  kRefused,
  kCount
};
constexpr auto names_of(NegotiationVow) {
  return std::to_array<std::string_view>({"none", "promised", "refused"});
}

/// What one member is known to have said in a negotiation.
struct NegotiationEntry {
  std::string uav;
  bool offered = false;
  std::vector<Parameter> offer;
  NegotiationVow vow = NegotiationVow::kNone;
  std::uint64_t fingerprint = 0;  ///< of the result that was promised
  std::string why;  ///< it was refused
  bool lost = false;  ///< restarted since
  bool operator==(const NegotiationEntry&) const = default;
};
SKEIN_WIRE_FIELDS(NegotiationEntry, uav, offered, offer, vow, fingerprint, why, lost)

/// All that a UAV knows of a negotiation: from the terms that its opener fixed to what each member
/// said. Source: spec 7.4.
struct NegotiationMessage {
  SampleHeader header;
  std::string from;
  std::string to;
  std::string subject;
  std::uint32_t mission_id = 0;  ///< of the terms
  std::string modality;
  std::vector<std::string> members;  ///< in order
  std::uint64_t model = 0;  ///< hash of the interaction model
  std::vector<Parameter> parameters;  ///< of the modality
  std::string opener;
  std::int64_t opened = 0;  ///< [ns]
  std::int64_t deadline = 0;  ///< [ns]
  std::vector<NegotiationEntry> entries;  ///< one for each member, in their order
  bool wants_echo = false;
  bool operator==(const NegotiationMessage&) const = default;
};
SKEIN_WIRE_FIELDS(NegotiationMessage, header, from, to, subject, mission_id, modality, members,
    model, parameters, opener, opened, deadline, entries, wants_echo)

/// What an operator asks of the ground station. World channel; said again until it is answered. The
/// instance tells apart the stations that operators sit at, which are all of one node.
struct OperatorRequest {
  SampleHeader header;
  std::string who;  ///< the operator
  std::uint64_t number = 0;  ///< of this operator's requests, growing: one is done once
  std::string request;  ///< a list of actions: docs/operators.md
  bool operator==(const OperatorRequest&) const = default;
};
SKEIN_WIRE_FIELDS(OperatorRequest, header, who, number, request)

/// What came of an operator's request: once it is accepted or refused, and again whenever one of
/// its commands comes to its end. World channel.
struct OperatorReply {
  SampleHeader header;
  std::string who;
  std::uint64_t number = 0;
  bool accepted = false;
  bool complete = false;  ///< nothing more will come
  std::vector<std::string> problems;  ///< why it was not accepted, all at once
  std::vector<CommandEntry> commands;  ///< that were issued for it
  bool operator==(const OperatorReply&) const = default;
};
SKEIN_WIRE_FIELDS(OperatorReply, header, who, number, accepted, complete, problems, commands)

/// One line of the event log. World channel.
struct JournalEntry {
  SampleHeader header;
  std::string record;  ///< one JSON object, without newline
  std::uint64_t line = 0;  ///< from 1, the same when it is given out again; 0: never again
  bool operator==(const JournalEntry&) const = default;
};
SKEIN_WIRE_FIELDS(JournalEntry, header, record, line)

}  // namespace skein::wire
