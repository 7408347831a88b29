// SPDX-License-Identifier: Apache-2.0
// What several slots share on the wire (idl/common.idl).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire_fields.hpp"

/// Plain C++ images of the IDL types, with the same fields in the same order. They are what crosses
/// a channel, not what decisions are made of: the shell of each node converts.
/// Conventions of all of them: positions are metres in the scenario's local frame, east north up;
/// angles are radians counter-clockwise from east; times are nanoseconds of mission time.
namespace skein::wire {

/// Every enumeration of the wire names its first value past the end, `kCount`: a value at or above
/// it is malformed. `names_of(E)` gives the names of the others, in order.
template <class E>
concept WireEnum = std::is_enum_v<E> && requires {
  E::kCount;
};

/// The name of an enumerator; "?" if out of range.
template <WireEnum E>
constexpr std::string_view name_of(E value) {
  return value < E::kCount ? names_of(value)[static_cast<std::size_t>(value)] : "?";
}

inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

/// Stamped by the blackboard, except `instance`, which a sender chooses. Source: spec 1.3.
struct SampleHeader {
  std::uint32_t origin = 0;           ///< key: number of the node that made the sample
  std::uint32_t instance = 0;         ///< key: which of the origin's values of this slot
  std::uint32_t destination = 0;      ///< key: node number; 0: everybody
  std::uint64_t incarnation = 0;      ///< of the origin: grows with each of its starts
  std::uint64_t sequence_number = 0;  ///< from 1; events: per destination; others: per origin
  std::int64_t mission_time = 0;      ///< [ns] when it was sent
  std::int64_t expires = kNever;      ///< [ns] events: not to be handled after this instant
  std::uint32_t mission = 0;          ///< id of the mission it belongs to
  bool operator==(const SampleHeader&) const = default;
};
SKEIN_WIRE_FIELDS(SampleHeader, origin, instance, destination, incarnation, sequence_number,
                  mission_time, expires, mission)

struct Vector3 {
  double x = 0;  ///< east
  double y = 0;  ///< north
  double z = 0;  ///< up
  bool operator==(const Vector3&) const = default;
};
SKEIN_WIRE_FIELDS(Vector3, x, y, z)

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
  return std::to_array<std::string_view>(
      {"scheduled", "started", "running", "aborting", "ended", "aborted"});
}

enum class LiteralKind : std::uint32_t { kTaskState, kMessage, kTime, kCount };
constexpr auto names_of(LiteralKind) {
  return std::to_array<std::string_view>({"task-state", "message", "time"});
}

/// One condition, possibly negated. Which fields count follows from `kind`. Source: spec 2.2.
struct Literal {
  LiteralKind kind = LiteralKind::kTaskState;
  std::uint64_t task = 0;                   ///< kTaskState
  TaskState state = TaskState::kScheduled;  ///< kTaskState
  std::string message;                      ///< kMessage
  std::int64_t instant = 0;                 ///< kTime [ns]
  bool passed = false;                      ///< kTime: true when `instant` must have passed
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
  std::vector<Clause> preconditions;    ///< a conjunction; empty: satisfied
  std::vector<Clause> exit_conditions;  ///< a conjunction; empty: never satisfied
  bool has_synchronisation = false;     ///< whether the four fields below count
  std::uint64_t synchronisation = 0;    ///< id common to all who take part
  std::vector<std::string> senders;
  std::vector<std::string> receivers;
  bool has_deadline = false;
  std::int64_t deadline = 0;  ///< [ns]
  bool operator==(const TaskSpec&) const = default;
};
SKEIN_WIRE_FIELDS(TaskSpec, id, type, parameters, preconditions, exit_conditions,
                  has_synchronisation, synchronisation, senders, receivers, has_deadline, deadline)

}  // namespace skein::wire
