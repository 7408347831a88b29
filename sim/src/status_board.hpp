// SPDX-License-Identifier: Apache-2.0
// The statuses that one vehicle gives of its tasks.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

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
    effects.push_back(FunctionalStatus{uav_, status, at});
    last_.insert_or_assign(task, std::move(status));
  }
  /// A task not begun yet, waiting for its pilot: known, though nothing was told.
  void note(TaskId task) { last_.try_emplace(task); }
  bool knows(TaskId task) const { return last_.count(task) > 0; }
  /// Tells again what was told last of a known task, if anything was.
  void repeat(TaskId task, MissionTime at, std::vector<Effect>& effects) const {
    if (const auto& status = last_.at(task)) effects.push_back(FunctionalStatus{uav_, *status, at});
  }
  void forget() { last_.clear(); }
  const std::string& uav() const { return uav_; }

 private:
  std::string uav_;
  std::map<TaskId, std::optional<functional::Status>> last_;
};

}  // namespace skein::sim
