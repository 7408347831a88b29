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
  std::optional<std::string> background_type;  ///< absent: no background routine
  /// A task of this type that nothing ends (no parameter `duration`, no exit conditions) is done
  /// for want of anything else: once it is active DEP and NUT leave it out, and what is dispatched
  /// and uses a resource of it interrupts it. Absent: there are none.
  std::optional<std::string> idle_type = {};
  std::optional<Duration> functional_timeout;    ///< absent: wait for ever
  Duration urgent_wait = Duration::seconds(10);  ///< longest wait of a VUT task
  /// How long a partner's SyncWord::kThere is valid. A waiting UAV repeats its own after half of
  /// that time, sends kDone when it has synchronised, and kWithdrawn when it gives up. Absent:
  /// messages are valid for ever and are never withdrawn (T III.2.3).
  std::optional<Duration> sync_validity = {};
  Duration background_retry = Duration::seconds(5);  ///< before a refused routine is tried again
  /// A task that is aborted for want of an answer is interrupted, too, in case its performer has
  /// the dispatch by then, or gets it later.
  bool interrupts_unanswered = false;
  /// An urgent task takes the place of incompatible urgent ones before it that still wait: they are
  /// aborted. Otherwise each is dispatched once what it displaced is over.
  bool last_urgent_counts = false;
};

/// One line of a status board.
struct TaskStatus {
  TaskId id;
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;
  bool operator==(const TaskStatus&) const = default;
};

/// A task in the plan. Its references point into the executive and are valid until the next
/// handle().
struct TaskView {
  TaskId id;
  const std::string& type;
  const Parameters& parameters;
  const Synchronisation* synchronisation;  ///< nullptr unless the type is `synchronise`
  TaskState state;
  const std::string& reason;
  AbortCause cause;
  /// Of Config::idle_type and without an end: interrupted by what needs its resources.
  bool gives_way;
};

/// A running synchronisation task that waits for partners.
struct Wait {
  TaskId id;
  std::uint64_t synchronisation = 0;
  MissionTime since;
  std::vector<std::string> awaited;  ///< senders whose message is missing, in order
};

/// Keeps a plan of tasks with event-driven dependencies and executes it. It reasons on dependencies
/// only; the content of a task is for the functional layer (of a joint task, for the supervisor).
///
///   from              on                                             to
///   (new)             START, coherent                                scheduled
///   (new)             START, incoherent                              aborted
///   scheduled         Π satisfied, or urgent and free to go          started
///   scheduled         Π false for ever, Ξ satisfied, ABORT; an       aborted
///                     incompatible VUT of one that is urgent, too:
///                     see Config
///   started           running from its performer (functional layer   running
///                     or supervisor)
///   started, running  ended from its performer                       ended
///   started, running  aborted from its performer                     aborted
///   started           no answer within functional_timeout            aborted; see Config
///   started           started from its performer, which still waits  started, time-out begins anew
///   started, running  Ξ satisfied, ABORT, VUT of an incompatible     aborting
///   aborting          ended or aborted; no answer within time-out    aborted
///
/// Any other status changes nothing and gives a Notice. Relinquish takes tasks out of the plan
/// without a transition. The executive itself takes a synchronise task from scheduled over started
/// to running, and from aborting to aborted in the same step.
///
/// Laws: one input sequence has one outcome; if several transitions are possible in one step, exit
/// conditions come first, then urgent tasks, then preconditions, the lowest id first in each.
/// Cost: an input costs in proportion to the conditions on the facts that it changes (a VUT also to
/// the active tasks that it interrupts), with logarithmic look-ups; it does not depend on the size
/// of the plan, except that DEP and NUT create one condition for each task not yet terminal.
/// Thread rule: one thread at a time.
/// Source: T III, spec 2.
class Executive {
 public:
  explicit Executive(Config config);
  ~Executive();
  Executive(Executive&&) noexcept;
  Executive& operator=(Executive&&) noexcept;

  /// Processes first the instants up to and including `now`, in order, each as an event of its own;
  /// then the input. A `now` before the last one counts as the last one.
  Effects handle(const Input& input, MissionTime now);
  /// A running synchronisation waits for its partners no longer: it is aborted, for this reason.
  /// Instants up to `now` are processed first, as in handle(). No effect on any other task.
  Effects give_up(TaskId synchronisation, const std::string& why, MissionTime now);

  /// The next instant of a time condition or a timer; call handle(Tick{}, …) then. Absent: none.
  std::optional<MissionTime> next_wakeup() const;

  /// The tasks of the plan in the order of their ids, background routine included. Cost: O(n),
  /// n tasks in the plan.
  std::vector<TaskStatus> tasks() const;
  /// Cost: linear in the number of waiting tasks and their senders.
  std::vector<Wait> waits() const;
  /// Grows whenever what tasks() gives may have changed, and never decreases. Cost: O(1).
  std::uint64_t changes() const;
  /// Absent: never started, or suppressed.
  std::optional<TaskView> find(TaskId id) const;
  /// The Π and Ξ in force, with the conditions that DEP and NUT added. Empty once they no longer
  /// matter (Π once dispatched or urgent, both once terminal), and for a task that is not in the
  /// plan.
  Formula preconditions(TaskId id) const;
  Formula exit_conditions(TaskId id) const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::executive
