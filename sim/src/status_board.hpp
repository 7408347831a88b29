// SPDX-License-Identifier: Apache-2.0
// The statuses that one vehicle gives of its tasks.
#pragma once

#include <string>
#include <vector>

#include "skein/functional/status_memory.hpp"
#include "skein/sim/messages.hpp"

namespace skein::sim {

using functional::TaskId;
using functional::TaskState;

/// Remembers the last status of every task, so that a request that comes twice is answered, not
/// executed, twice.
class StatusBoard {
 public:
  explicit StatusBoard(std::string uav) : uav_(std::move(uav)) {}

  void tell(TaskId task, TaskState state, std::string reason, MissionTime at,
            std::vector<Effect>& effects) {
    functional::Status status{task, state, std::move(reason)};
    told_.set(status);
    effects.push_back(FunctionalStatus{uav_, std::move(status), at});
  }
  /// A task not begun yet, waiting for its pilot: known, though nothing was told.
  void note(TaskId task) { told_.note(task); }
  bool knows(TaskId task) const { return told_.knows(task); }
  /// Tells again what was told last of a known task, if anything was.
  void repeat(TaskId task, MissionTime at, std::vector<Effect>& effects) const {
    if (const auto status = told_.last(task))
      effects.push_back(FunctionalStatus{uav_, *status, at});
  }
  void forget() { told_.forget(); }
  const std::string& uav() const { return uav_; }

 private:
  std::string uav_;
  functional::StatusMemory told_;
};

}  // namespace skein::sim
