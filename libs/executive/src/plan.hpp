// SPDX-License-Identifier: Apache-2.0
// The table of tasks: those in the plan, and the last states of those that have left it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "formula_state.hpp"
#include "skein/executive/task.hpp"
#include "skein/foundation/byte_book.hpp"
#include "watch.hpp"

namespace skein::executive {

/// A task of the plan. Its slot is its index in the table. Slots are used again after a SUPPRESS;
/// the versions of their formulas go on, so that watches of the former task stay stale.
struct TaskRecord {
  TaskId id;
  std::string type;
  Parameters parameters;
  std::unique_ptr<Synchronisation> synchronisation;
  std::string reason;
  AbortCause cause = AbortCause::kOther;
  FormulaState preconditions, exit;
  WatchList watchers;                    ///< literals that name this task
  std::vector<std::uint32_t> resources;  ///< numbers of ResourceUse
  std::uint32_t blockers = 0;            ///< number of tasks that this urgent task still waits for
  std::uint32_t place_among_open = 0;
  TaskState state = TaskState::kScheduled;
  bool urgent = false;  ///< inserted by VUT and not yet dispatched
  bool joint = false;
  bool background = false;
  bool idle = false;     ///< of Config::idle_type, without an end
  bool answers = false;  ///< over, and the answer to its interruption may still come

  bool uses(std::uint32_t resource) const {
    return std::find(resources.begin(), resources.end(), resource) != resources.end();
  }
  FormulaState& formula(Role role) { return role == Role::kExit ? exit : preconditions; }
  const FormulaState& formula(Role role) const {
    return role == Role::kExit ? exit : preconditions;
  }
};

/// The tasks by slot and by id. Invariant: the state of every task that was ever inserted is known
/// (except of finished background routines), also after it has left the plan, for about one byte
/// each. References to records stay valid.
class Plan {
 public:
  using Slot = std::uint32_t;

  /// Inserts a task; of its record only id, type, parameters and synchronisation are filled in.
  /// Precondition: may_insert(id).
  Slot insert(Task&& task, bool background);
  void set_state(Slot slot, TaskState state);
  /// Removes a terminal task; its state remains known, except of a background routine.
  void remove(Slot slot);
  /// Allows a task with this id, which has been removed, to be inserted again.
  void readmit(TaskId id) { left_.set(id.value(), left_.of(id.value()) | kReadmitted); }
  bool may_insert(TaskId id) const;

  TaskRecord& operator[](Slot slot) { return records_[slot]; }
  const TaskRecord& operator[](Slot slot) const { return records_[slot]; }
  std::optional<Slot> find(TaskId id) const;
  /// The state of a task, also of a suppressed one; absent for an id never inserted.
  std::optional<TaskState> state_of(TaskId id) const;

  /// Tasks not yet terminal, background routine left out, in the order of their ids.
  std::vector<TaskId> open() const;
  /// All tasks in the plan, in the order of their ids.
  const std::map<TaskId, Slot>& slots() const { return slots_; }
  /// Grows whenever a task comes, goes or changes its state; never decreases.
  std::uint64_t changes() const { return changes_; }

 private:
  static constexpr std::uint8_t kReadmitted = 0x80;  ///< relinquished: may come back
  void close(Slot slot);

  std::deque<TaskRecord> records_;
  std::vector<Slot> free_;
  std::vector<Slot> open_;
  std::unordered_map<TaskId, Slot> by_id_;  ///< in the plan
  ByteBook left_;  ///< 1 + state of each task that has left the plan, and kReadmitted
  std::map<TaskId, Slot> slots_;
  std::uint64_t changes_ = 0;
};

}  // namespace skein::executive
