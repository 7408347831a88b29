// SPDX-License-Identifier: Apache-2.0
// Slots of class event: handled exactly once and in order (idl/event.idl).
#pragma once

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

enum class RequestKind : std::uint32_t {
  kStart,
  kAbort,
  kProcessMessage,
  kUpdateConditions,
  kSuppress,
  kCount
};
constexpr auto names_of(RequestKind) {
  return std::to_array<std::string_view>(
      {"START", "ABORT", "PROCESS-MSG", "UPDATE-COND", "SUPPRESS"});
}

enum class InsertionMode : std::uint32_t { kSeq, kVut, kDep, kNut, kCount };
constexpr auto names_of(InsertionMode) {
  return std::to_array<std::string_view>({"SEQ", "VUT", "DEP", "NUT"});
}

/// A request to an executive. Which fields count follows from `kind`. Source: spec 2.3.
struct TaskRequest {
  SampleHeader header;
  std::uint64_t command = 0;  ///< the sender's number for it, given back in the reply
  RequestKind kind = RequestKind::kStart;
  InsertionMode mode = InsertionMode::kSeq;  ///< kStart
  TaskSpec task;                             ///< kStart
  std::uint64_t id = 0;                      ///< kAbort, kUpdateConditions, kSuppress
  std::string message;                       ///< kProcessMessage
  bool has_preconditions = false;            ///< kUpdateConditions: replace them
  bool has_exit_conditions = false;          ///< kUpdateConditions: replace them
  std::vector<Clause> preconditions;
  std::vector<Clause> exit_conditions;
  bool operator==(const TaskRequest&) const = default;
};
SKEIN_WIRE_FIELDS(TaskRequest, header, command, kind, mode, task, id, message, has_preconditions,
                  has_exit_conditions, preconditions, exit_conditions)

struct RequestReply {
  SampleHeader header;
  std::uint64_t command = 0;
  RequestKind kind = RequestKind::kStart;
  std::uint64_t id = 0;  ///< of the task, where there is one
  bool accepted = false;
  std::string why;  ///< of a refusal
  bool operator==(const RequestReply&) const = default;
};
SKEIN_WIRE_FIELDS(RequestReply, header, command, kind, id, accepted, why)

/// One transition of one task.
struct TaskEvent {
  SampleHeader header;
  std::string uav;
  std::uint64_t id = 0;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;
  std::int64_t at = 0;  ///< [ns] when it happened
  bool operator==(const TaskEvent&) const = default;
};
SKEIN_WIRE_FIELDS(TaskEvent, header, uav, id, type, state, reason, at)

enum class FunctionalRequestKind : std::uint32_t { kDispatch, kInterrupt, kCount };
constexpr auto names_of(FunctionalRequestKind) {
  return std::to_array<std::string_view>({"dispatch", "interrupt"});
}

/// From an executive to the functional layer of its UAV.
struct FunctionalRequest {
  SampleHeader header;
  std::string uav;
  FunctionalRequestKind kind = FunctionalRequestKind::kDispatch;
  std::uint64_t id = 0;
  std::string type;                   ///< kDispatch
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
  bool operator==(const FunctionalStatus&) const = default;
};
SKEIN_WIRE_FIELDS(FunctionalStatus, header, uav, id, state, reason)

/// Source: spec 2.6.
struct SyncMessage {
  SampleHeader header;
  std::uint64_t id = 0;  ///< of the synchronisation
  std::string from;
  std::string to;  ///< the UAV it is for, also when the ground relays it
  bool operator==(const SyncMessage&) const = default;
};
SKEIN_WIRE_FIELDS(SyncMessage, header, id, from, to)

enum class AlarmState : std::uint32_t { kRaised, kConfirmed, kInfirmed, kCount };
constexpr auto names_of(AlarmState) {
  return std::to_array<std::string_view>({"raised", "confirmed", "infirmed"});
}

struct Alarm {
  SampleHeader header;
  std::uint32_t id = 0;
  AlarmState state = AlarmState::kRaised;
  Vector3 position;
  double radius = 0;  ///< [m]
  double belief = 0;  ///< in [0, 1]
  bool operator==(const Alarm&) const = default;
};
SKEIN_WIRE_FIELDS(Alarm, header, id, state, position, radius, belief)

/// One line of the event log. World channel.
struct JournalEntry {
  SampleHeader header;
  std::string record;  ///< one JSON object, without newline
  bool operator==(const JournalEntry&) const = default;
};
SKEIN_WIRE_FIELDS(JournalEntry, header, record)

}  // namespace skein::wire
