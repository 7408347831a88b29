// SPDX-License-Identifier: Apache-2.0
// The table of tasks: what is in the plan, what is remembered of what has left it.
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

/// A task of the plan. Its slot is its place in the table, given again after a SUPPRESS; the
/// versions of its formulas go on, so that watches of the former task stay stale.
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
  std::optional<MissionTime> due;        ///< of the timer that counts: urgent wait or time-out
  std::uint32_t blockers = 0;            ///< tasks that an urgent one still waits for
  std::uint32_t place_among_open = 0;
  TaskState state = TaskState::kScheduled;
  bool urgent = false;  ///< inserted by VUT and not yet dispatched
  bool joint = false;
  bool background = false;

  bool uses(std::uint32_t resource) const {
    return std::find(resources.begin(), resources.end(), resource) != resources.end();
  }
  FormulaState& formula(Role role) { return role == Role::kExit ? exit : preconditions; }
  const FormulaState& formula(Role role) const {
    return role == Role::kExit ? exit : preconditions;
  }
};

/// Invariant: every id that was ever inserted (background routine apart, once over) is known, with
/// its state, whether or not it is still in the plan: a byte of each that has left it. References
/// to records stay valid.
class Plan {
 public:
  using Slot = std::uint32_t;

  /// Precondition: may_insert(id). The record is blank but for id, type, parameters,
  /// synchronisation.
  Slot insert(Task&& task, bool background);
  void set_state(Slot slot, TaskState state);
  /// Takes a terminal task out; what it was remains known unless it is of the background routine.
  void remove(Slot slot);
  /// A task of this id, which has been removed, may be inserted again.
  void readmit(TaskId id) { left_.set(id.value(), left_.of(id.value()) | kReadmitted); }
  bool may_insert(TaskId id) const;

  TaskRecord& operator[](Slot slot) { return records_[slot]; }
  const TaskRecord& operator[](Slot slot) const { return records_[slot]; }
  std::optional<Slot> find(TaskId id) const;
  /// Also of a suppressed task; absent for an id never inserted.
  std::optional<TaskState> state_of(TaskId id) const;

  /// Tasks not yet terminal, background routine left out, in the order of their ids.
  std::vector<TaskId> open() const;
  /// All that are in the plan, in the order of their ids. What has left it costs nothing here.
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
  ByteBook left_;  ///< 1 + state of each that has left the plan, and kReadmitted
  std::map<TaskId, Slot> slots_;
  std::uint64_t changes_ = 0;
};

}  // namespace skein::executive
