// SPDX-License-Identifier: Apache-2.0
// The outputs of the executive.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"

namespace skein::executive {

/// A task has entered `state`. `reason` says why a task was interrupted, cancelled or aborted; may
/// be empty. `cause` is the cause of that; if the abort that answers an interruption comes with
/// another cause, the cause of the interruption stays.
struct TaskEvent {
  TaskId id;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;
  AbortCause cause = AbortCause::kOther;
  bool operator==(const TaskEvent&) const = default;
};

/// The functional layer (for a joint task the supervisor) is to carry out this task. Its type and
/// parameters are in Executive::find(id), until the next handle().
struct Dispatch {
  TaskId id;
  bool joint = false;
  bool operator==(const Dispatch&) const = default;
};

/// The functional layer (for a joint task the supervisor) is to stop this task and then report
/// `aborted`.
struct Interrupt {
  TaskId id;
  bool joint = false;
  bool operator==(const Interrupt&) const = default;
};

/// This UAV's synchronisation message for synchronisation `id` is to be sent to the UAV `to`.
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

/// An event of another task while a joint task is under way. Source: T III.2.4.
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
