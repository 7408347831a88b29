// SPDX-License-Identifier: Apache-2.0
// Urgent (VUT) tasks between their insertion by START and their dispatch.
#pragma once

#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "conditions.hpp"
#include "plan.hpp"

namespace skein::executive {

/// An urgent task waits until no incompatible task is active, or until force(). Source: T III.2.1
/// (VUT), spec 2.3.
class Urgents {
 public:
  /// Adds an urgent task that waits until all `blockers` are terminal; without any it is ready at
  /// once. `moves`: it uses the resource kMotion.
  void enter(TaskRecord& record, Plan::Slot slot, const std::set<TaskId>& blockers, bool moves);
  /// Makes the task ready although it still has blockers.
  void force(TaskRecord& record, Plan::Slot slot);
  /// The task `blocker` is terminal: urgent tasks no longer wait for it.
  void over(TaskId blocker, Plan& plan);
  /// The next ready task.
  std::optional<Plan::Slot> take(const Plan& plan);
  /// The task is not urgent any more: it was dispatched, or never will be.
  void leave(TaskRecord& record);
  /// The task was handed over to another executive (Relinquish).
  void let_go(TaskId task);
  /// Those that were inserted before it, are not dispatched yet, and use a resource of it; in the
  /// order of their ids.
  std::vector<TaskId> in_place_of(const TaskRecord& last, const Plan& plan) const;
  /// Whether some urgent task uses kMotion.
  bool any_to_move() const { return !to_move_.empty(); }

 private:
  ReadyQueue ready_;
  std::unordered_map<TaskId, std::vector<TaskId>> waiting_for_;  ///< blocker → urgent tasks
  std::set<TaskId> waiting_;
  std::set<TaskId> to_move_;
};

}  // namespace skein::executive
