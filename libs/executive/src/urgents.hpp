// SPDX-License-Identifier: Apache-2.0
// Urgent tasks between their START and their start.
#pragma once

#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "conditions.hpp"
#include "plan.hpp"

namespace skein::executive {

/// Each waits until no task that is incompatible with it is left, or until it is told to go all the
/// same. Source: T III.2.1 (VUT), spec 2.3.
class Urgents {
 public:
  /// The task waits for these to be over; for none, it goes. `moves`: it uses motion.
  void enter(TaskRecord& record, Plan::Slot slot, const std::set<TaskId>& blockers, bool moves);
  /// It goes, whoever it waited for.
  void force(TaskRecord& record, Plan::Slot slot);
  /// Nobody waits for this task any more.
  void over(TaskId blocker, Plan& plan);
  /// The next that may go.
  std::optional<Plan::Slot> take(const Plan& plan);
  /// It is urgent no more: it has started, or never will.
  void leave(TaskRecord& record);
  /// Likewise, and somebody else has it now.
  void let_go(TaskId task);
  /// One is about to move.
  bool any_to_move() const { return !to_move_.empty(); }

 private:
  ReadyQueue ready_;
  std::unordered_map<TaskId, std::vector<TaskId>> waiting_for_;  ///< blocker → urgent tasks
  std::set<TaskId> to_move_;
};

}  // namespace skein::executive
