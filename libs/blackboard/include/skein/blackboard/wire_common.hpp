// SPDX-License-Identifier: Apache-2.0
// What several slots share on the wire.
// Written by idl/generate_wire.py from idl/common.idl: change that, and run it.
// clang-format off
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire_fields.hpp"

namespace skein::wire {

/// Stamped by the blackboard, except `instance`, which a sender chooses. Source: spec 1.3.
struct SampleHeader {
  std::uint32_t origin = 0;  ///< key: number of the node that made the sample
  std::uint32_t instance = 0;  ///< key: which of the origin's values of this slot
  std::uint32_t destination = 0;  ///< key: node number; 0: everybody
  std::uint64_t incarnation = 0;  ///< of the origin: grows with each of its starts
  std::uint64_t sequence_number = 0;  ///< from 1; events: per destination; others: per origin
  std::int64_t mission_time = 0;  ///< [ns] when it was sent
  std::int64_t expires = kNever;  ///< [ns] events: not to be handled after this instant
  std::uint32_t mission = 0;  ///< id of the mission it belongs to
  std::vector<std::uint32_t> via;  ///< who passed it on, in their order; empty: came directly
  bool operator==(const SampleHeader&) const = default;
};
SKEIN_WIRE_FIELDS(SampleHeader, origin, instance, destination, incarnation, sequence_number,
    mission_time, expires, mission, via)

struct Vector3 {
  double x = 0;  ///< east
  double y = 0;  ///< north
  double z = 0;  ///< up
  bool operator==(const Vector3&) const = default;
};
SKEIN_WIRE_FIELDS(Vector3, x, y, z)

/// In single precision, for what is said often: a millimetre within 16 km of the origin.
struct FloatVector3 {
  float x = 0;  ///< east
  float y = 0;  ///< north
  float z = 0;  ///< up
  bool operator==(const FloatVector3&) const = default;
};
SKEIN_WIRE_FIELDS(FloatVector3, x, y, z)

struct Detection {
  std::string kind;  ///< of object: "fire", "vehicle"
  FloatVector3 position;
  float spread = 0;  ///< [m] standard deviation of the position
  float confidence = 0;  ///< in [0, 1]
  bool operator==(const Detection&) const = default;
};
SKEIN_WIRE_FIELDS(Detection, kind, position, spread, confidence)

/// A named value of a task: text, numbers, or both. A list of waypoints is x, y, z repeated.
struct Parameter {
  std::string name;
  std::string text;
  std::vector<double> numbers;
  bool operator==(const Parameter&) const = default;
};
SKEIN_WIRE_FIELDS(Parameter, name, text, numbers)

enum class TaskState : std::uint32_t {
  kScheduled,
  kStarted,
  kRunning,
  kAborting,
  kEnded,
  kAborted,
  kCount
};
constexpr auto names_of(TaskState) {
  return std::to_array<std::string_view>({"scheduled", "started", "running", "aborting", "ended",
    "aborted"});
}

enum class LiteralKind : std::uint32_t {
  kTaskState,
  kMessage,
  kTime,
  kCount
};
constexpr auto names_of(LiteralKind) {
  return std::to_array<std::string_view>({"task-state", "message", "time"});
}

/// One condition, possibly negated. Which fields count follows from `kind`. Source: spec 2.2.
struct Literal {
  LiteralKind kind = LiteralKind::kTaskState;
  std::uint64_t task = 0;  ///< kTaskState
  TaskState state = TaskState::kScheduled;  ///< kTaskState
  std::string message;  ///< kMessage
  std::int64_t instant = 0;  ///< kTime [ns]
  bool passed = false;  ///< kTime: true when `instant` must have passed
  bool negated = false;
  bool is_optional = false;  ///< modality: true optional, false mandatory
  bool operator==(const Literal&) const = default;
};
SKEIN_WIRE_FIELDS(Literal, kind, task, state, message, instant, passed, negated, is_optional)

/// A disjunction.
struct Clause {
  std::vector<Literal> literals;
  bool operator==(const Clause&) const = default;
};
SKEIN_WIRE_FIELDS(Clause, literals)

/// A task of the executive. Source: spec 2.1, 2.6.
struct TaskSpec {
  std::uint64_t id = 0;
  std::string type;
  std::vector<Parameter> parameters;
  std::vector<Clause> preconditions;  ///< a conjunction; empty: satisfied
  std::vector<Clause> exit_conditions;  ///< a conjunction; empty: never satisfied
  bool has_synchronisation = false;  ///< whether the four fields below count
  std::uint64_t synchronisation = 0;  ///< id common to all who take part
  std::vector<std::string> senders;
  std::vector<std::string> receivers;
  bool has_deadline = false;
  std::int64_t deadline = 0;  ///< [ns]
  bool operator==(const TaskSpec&) const = default;
};
SKEIN_WIRE_FIELDS(TaskSpec, id, type, parameters, preconditions, exit_conditions,
    has_synchronisation, synchronisation, senders, receivers, has_deadline, deadline)

/// Between `least` and `most` after the end of another high-level task [ns].
struct GoalBound {
  std::uint64_t goal = 0;
  bool on_end = false;
  std::int64_t least = 0;
  std::int64_t most = kNever;  ///< no bound
  bool operator==(const GoalBound&) const = default;
};
SKEIN_WIRE_FIELDS(GoalBound, goal, on_end, least, most)

/// A high-level task as it is asked for. The name of each argument is its kind: "name" (text),
/// "number" (one number), "location" (x, y, z) or "names" (text, separated by spaces).
struct MissionTask {
  std::uint64_t id = 0;
  std::string name;
  std::vector<Parameter> arguments;
  std::int64_t start_before = kNoInstant;  ///< [ns]; kNoInstant: free, as the next three
  std::int64_t start_after = kNoInstant;
  std::int64_t end_before = kNoInstant;
  std::int64_t end_after = kNoInstant;
  std::vector<GoalBound> after;
  bool operator==(const MissionTask&) const = default;
};
SKEIN_WIRE_FIELDS(MissionTask, id, name, arguments, start_before, start_after, end_before,
    end_after, after)

enum class GoalState : std::uint32_t {
  kReceived,
  kPlanned,
  kUnderWay,
  kAchieved,
  kFailed,
  kCancelled,
  kHandedOver,
  kCount
};
constexpr auto names_of(GoalState) {
  return std::to_array<std::string_view>({"received", "planned", "under-way", "achieved", "failed",
    "cancelled", "handed-over"});
}

/// Where a high-level task stands.
struct GoalEntry {
  std::uint64_t id = 0;
  std::uint64_t mission = 0;
  std::string statement;
  GoalState state = GoalState::kReceived;
  std::string why;  ///< of failed and cancelled
  std::string asked_by;
  std::string done;  ///< of it, in words
  bool operator==(const GoalEntry&) const = default;
};
SKEIN_WIRE_FIELDS(GoalEntry, id, mission, statement, state, why, asked_by, done)

/// What a change of the world is about.
enum class WorldPart : std::uint32_t {
  kAir,
  kPlace,
  kGround,
  kCount
};
constexpr auto names_of(WorldPart) {
  return std::to_array<std::string_view>({"air", "place", "ground"});
}

/// What is known of cells of the ground from now on.
enum class CellChange : std::uint32_t {
  kAsBefore,
  kQuiet,
  kAlarm,
  kFire,
  kCount
};
constexpr auto names_of(CellChange) {
  return std::to_array<std::string_view>({"as-before", "quiet", "alarm", "fire"});
}

enum class DependenceKind : std::uint32_t {
  kEnded,
  kRunning,
  kOver,
  kCount
};
constexpr auto names_of(DependenceKind) {
  return std::to_array<std::string_view>({"ended", "running", "over"});
}

/// What a planned task waits for of another one. Source: spec 3.4.
struct TaskDependence {
  DependenceKind kind = DependenceKind::kEnded;
  std::uint64_t task = 0;
  bool operator==(const TaskDependence&) const = default;
};
SKEIN_WIRE_FIELDS(TaskDependence, kind, task)

enum class AlarmState : std::uint32_t {
  kRaised,
  kConfirmed,
  kInfirmed,
  kCount
};
constexpr auto names_of(AlarmState) {
  return std::to_array<std::string_view>({"raised", "confirmed", "infirmed"});
}

enum class CommandState : std::uint32_t {
  kIssued,
  kDelivered,  ///< to its UAV's node, which has not answered yet
  kAcknowledged,
  kRefused,
  kExpired,
  kCount
};
constexpr auto names_of(CommandState) {
  return std::to_array<std::string_view>({"issued", "delivered", "acknowledged", "refused",
    "expired"});
}

/// A command of the ground station to a UAV, and what came of it.
struct CommandEntry {
  std::uint64_t command = 0;  ///< its number
  std::string uav;
  std::string what;  ///< for people: "DEGREE 1"
  std::string asked_by;  ///< for people: "step detection", "request ada 3"
  CommandState state = CommandState::kIssued;
  std::string why;
  std::int64_t issued = 0;  ///< [ns]
  std::int64_t settled = kNoInstant;  ///< [ns]
  bool operator==(const CommandEntry&) const = default;
};
SKEIN_WIRE_FIELDS(CommandEntry, command, uav, what, asked_by, state, why, issued, settled)

}  // namespace skein::wire
