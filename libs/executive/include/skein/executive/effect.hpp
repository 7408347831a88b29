// SPDX-License-Identifier: Apache-2.0
// Everything that the executive asks of the world around it, in order.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"

namespace skein::executive {

/// A transition. `reason` says why a task was interrupted, cancelled or aborted; may be empty.
/// `cause` is of that: the first one, where an interruption was answered with another.
struct TaskEvent {
  TaskId id;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;
  AbortCause cause = AbortCause::kOther;
  bool operator==(const TaskEvent&) const = default;
};

/// Carry this task out (functional layer; supervisor when joint). Its type and parameters are in
/// Executive::find(id), which still knows it when this effect is handled.
struct Dispatch {
  TaskId id;
  bool joint = false;
  bool operator==(const Dispatch&) const = default;
};

/// Stop this task, then report `aborted` (functional layer; supervisor when joint).
struct Interrupt {
  TaskId id;
  bool joint = false;
  bool operator==(const Interrupt&) const = default;
};

/// Send this UAV's message of synchronisation `id` to `to`.
struct SendSync {
  std::uint64_t id = 0;
  std::string to;
  SyncWord word = SyncWord::kThere;
  bool operator==(const SendSync&) const = default;
};

/// The answer to a request: one for each, before its other effects.
struct Reply {
  RequestKind request = RequestKind::kStart;
  std::optional<TaskId> id;  ///< absent for PROCESS-MSG
  bool accepted = true;
  std::string why;  ///< of a refusal
  bool operator==(const Reply&) const = default;
};

/// A status of another task while a joint task is under way. Source: T III.2.4.
struct ForwardToSupervisor {
  TaskEvent event;
  bool operator==(const ForwardToSupervisor&) const = default;
};

/// For the log: a late or duplicate status, an urgent task that waited too long, …
struct Notice {
  std::string text;
  bool operator==(const Notice&) const = default;
};

using Effect =
    std::variant<TaskEvent, Dispatch, Interrupt, SendSync, Reply, ForwardToSupervisor, Notice>;
using Effects = std::vector<Effect>;

}  // namespace skein::executive
