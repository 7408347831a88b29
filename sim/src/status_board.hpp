// SPDX-License-Identifier: Apache-2.0
// The task statuses that one vehicle has reported.
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
  /// The task was accepted but not begun (its pilot has not reacted yet), without a status so far.
  void note(TaskId task) { told_.note(task); }
  bool knows(TaskId task) const { return told_.knows(task); }
  /// Repeats the last status of a known task, if there was any.
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
