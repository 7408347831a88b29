// SPDX-License-Identifier: Apache-2.0
// What was told of each task.
#pragma once

#include <string>

#include "outbox.hpp"
#include "skein/functional/status_memory.hpp"

namespace skein::autopilot {

using functional::TaskId;
using functional::TaskState;

/// A request that comes twice is answered twice and carried out once.
class StatusBoard {
 public:
  void tell(TaskId task, TaskState state, std::string reason, Outbox& out) {
    functional::Status status{task, state, std::move(reason)};
    told_.set(status);
    out.add(std::move(status));
  }
  /// Taken on, though nothing can be told yet.
  void note(TaskId task) { told_.note(task); }
  bool knows(TaskId task) const { return told_.knows(task); }
  void repeat(TaskId task, Outbox& out) const {
    if (const auto status = told_.last(task)) out.add(*status);
  }

 private:
  functional::StatusMemory told_;
};

}  // namespace skein::autopilot
