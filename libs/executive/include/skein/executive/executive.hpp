// SPDX-License-Identifier: Apache-2.0
// The multi-level executive (MLE) of one UAV.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/resource.hpp"

namespace skein::executive {

/// Durations must be positive.
struct Config {
  std::string name;  ///< of this UAV, as in senders and receivers
  TypeTable types = TypeTable::elementary();
  std::optional<std::string> background_type;    ///< absent: no background routine
  std::optional<Duration> functional_timeout;    ///< absent: wait for ever
  Duration urgent_wait = Duration::seconds(10);  ///< longest wait of a VUT task
  /// How long it counts that a partner said it was there; who waits says it again at half of that,
  /// says when it has synchronised, and withdraws when it gives up. Absent: it counts for ever and
  /// is never taken back (T III.2.3).
  std::optional<Duration> sync_validity = {};
  Duration background_retry = Duration::seconds(5);  ///< before a refused routine is tried again
};

/// One line of a status board.
struct TaskStatus {
  TaskId id;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;
  bool operator==(const TaskStatus&) const = default;
};

/// What is kept of a task in the plan; references into the executive, valid until the next
/// handle().
struct TaskView {
  TaskId id;
  const std::string& type;
  const Parameters& parameters;
  const Synchronisation* synchronisation;  ///< nullptr unless the type is `synchronise`
  TaskState state;
  const std::string& reason;
  AbortCause cause;
};

/// Keeps a plan of tasks with event-driven dependencies and runs it. It reasons on dependencies
/// only; what a task is about is for the functional layer (or, joint, for the supervisor).
///
///   from              on                                             to
///   (new)             START, coherent                                scheduled
///   (new)             START, incoherent                              aborted
///   scheduled         Π satisfied, or urgent and free to go          started
///   scheduled         Π false for ever, Ξ satisfied, ABORT           aborted
///   started           running from who carries it out                running
///   started, running  ended from who carries it out                  ended
///   started, running  aborted from who carries it out                aborted
///   started           no answer within functional_timeout            aborted
///   started           started: it waits                              started, time-out begins anew
///   started, running  Ξ satisfied, ABORT, VUT of an incompatible     aborting
///   aborting          ended or aborted; no answer within time-out    aborted
///
/// Anything else changes nothing and gives a Notice. Relinquish takes tasks out of the plan without
/// a transition. A synchronise task goes scheduled → started →
/// running by itself, and aborting → aborted in the same step.
///
/// Laws: one input sequence has one outcome; of several things that may happen in one step, exit
/// conditions come first, then urgent tasks, then preconditions, the lowest id first in each.
/// Cost: an input costs in proportion to the conditions that name what it changes (and for a VUT to
/// the tasks under way that it interrupts), with logarithmic look-ups; never to the plan's size,
/// except that DEP and NUT create one condition for each task not yet terminal.
/// Thread rule: one thread at a time.
/// Source: T III, spec 2.
class Executive {
 public:
  explicit Executive(Config config);
  ~Executive();
  Executive(Executive&&) noexcept;
  Executive& operator=(Executive&&) noexcept;

  /// Instants up to and at `now` pass first, in order, each as an event of its own; then the input.
  /// A `now` before the last one counts as the last one.
  Effects handle(const Input& input, MissionTime now);

  /// The next instant that means something to a task; call handle(Tick{}, …) then. Absent: none.
  std::optional<MissionTime> next_wakeup() const;

  /// The tasks of the plan in the order of their ids, background routine included. Cost: O(n),
  /// n tasks in the plan.
  std::vector<TaskStatus> tasks() const;
  /// Grows whenever what tasks() gives may have changed, and never decreases. Cost: O(1).
  std::uint64_t changes() const;
  /// Absent: never started, or suppressed.
  std::optional<TaskView> find(TaskId id) const;
  /// The Π and Ξ in force: what DEP and NUT made of them, empty once they no longer matter (Π once
  /// dispatched or urgent, both once terminal). Empty for a task that is not in the plan.
  Formula preconditions(TaskId id) const;
  Formula exit_conditions(TaskId id) const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::executive
