// SPDX-License-Identifier: Apache-2.0
// A plan of elementary tasks, as deliberation makes it and as it is reported.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/executive/task.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/mission/high_level_task.hpp"

namespace skein::mission {

/// The state of another task that a task waits for.
enum class DependenceKind : std::uint8_t {
  kEnded,    ///< the other task has ended, and was not aborted
  kRunning,  ///< the other task is running
  kOver,     ///< the other task has ended or was aborted: for successors of a withdrawn task
  kCount
};
/// "ended", "running", "over".
std::string_view to_text(DependenceKind kind);
std::optional<DependenceKind> dependence_kind_from(std::string_view text);

struct Dependence {
  DependenceKind kind = DependenceKind::kEnded;
  executive::TaskId task;
  auto operator<=>(const Dependence&) const = default;
};

/// [least, most]; `most` may be Duration::max().
struct Interval {
  Duration least, most;
  bool operator==(const Interval&) const = default;
};

/// The UAVs that begin a joint task together; equal at all of them.
struct Gathering {
  std::uint64_t id = 0;              ///< derived from the task's type, arguments and members
  std::vector<std::string> members;  ///< sorted by name
  bool agreed = false;               ///< the members have agreed on the start
  bool operator==(const Gathering&) const = default;
};

/// (type, id, dependences, start, duration, time constraints, parameters, origin).
/// Source: T def. IV.2, spec 3.4.
struct ElementaryTask {
  executive::TaskId id;
  /// Name in the registry of task types: takeoff, goto, perceive, joint:NAME, …
  std::string type;
  std::string name;                  ///< name in the planning domain: "task-gotoxyz"
  executive::Parameters parameters;  ///< for the functional layer
  std::optional<executive::Synchronisation> synchronisation;
  std::optional<Gathering> gathering;  ///< of a joint task
  std::vector<Dependence> dependences;
  /// Dependences of its stop-task (stop-takeshot, stop-wait), which ends it. Source: spec 2.7.
  std::vector<Dependence> stop;
  Interval start;  ///< relative to the plan's origin
  /// Least and greatest duration; contingent. [0, 0] with `stop`: determined by the stop.
  Interval duration;
  bool open_ended = false;  ///< lasts until orders come: no stop, no greatest duration
  TimeConstraints time;
  GoalId origin;                     ///< the high-level task it comes from
  std::vector<world::Vector3> way;   ///< way-points of its motion [m] ENU; empty: none
  std::vector<std::string> methods;  ///< labels, from the high-level task down to this one
  double energy = 0;                 ///< expected, as a fraction of the full capacity
  double cost = 0;                   ///< in the units of the domain
  bool operator==(const ElementaryTask&) const = default;
};

/// The registry's entry for the task's type.
const functional::TaskType& type_of(const ElementaryTask& task);
/// True for a task that moves the vehicle or needs it to stay.
bool holds_vehicle(const ElementaryTask& task);
/// The devices that the task occupies while it is active.
std::vector<std::string> devices_of(const ElementaryTask& task);

/// Individual and joint tasks of one UAV in the order of planning. Source: T def. IV.1.
struct ElementaryPlan {
  MissionTime origin;  ///< reference of the tasks' relative starts
  std::vector<ElementaryTask> tasks;
  double cost = 0;
  double energy = 0;
  bool operator==(const ElementaryPlan&) const = default;
};

/// The task in the text form of the seeds, with seconds:
/// (TASKREQ TASK-GOTOXYZ 13 (DEPENDENCES ((ENDED 12))) (PARAMS …) (START-TIME 240 352.0)
/// (DURATION 88 113) (TIME-CONSTRAINTS NIL NIL NIL NIL) 702), and a stop-task as a line of its own,
/// (TASKREQ TASK-STOP-TAKESHOT 103 (DEPENDENCES ((ENDED 102))) …). One line for each, those of a
/// plan ended by newlines. Numbers are in their shortest form, without a point when whole; what has
/// no bound is UNLIMITED; constraints are start before, start after, end before, end after, in
/// mission time. Texts that are not symbols are put between quotes. The start of a stop-task is
/// when what it waits for comes about, as far as the plan says that; alone, not before its task.
std::string to_taskreq(const ElementaryTask& task);
std::string to_taskreq(const ElementaryPlan& plan);

/// Earliest and latest start and end of a task by the present temporal network of the plan.
struct TaskDates {
  MissionTime earliest_start, latest_start;  ///< latest may be MissionTime::max()
  MissionTime earliest_end, latest_end;
  bool operator==(const TaskDates&) const = default;
};

/// A task in a PlanReport.
struct PlannedTask {
  ElementaryTask task;
  TaskDates dates;
  bool committed = false;  ///< the executive has it
  bool operator==(const PlannedTask&) const = default;
};

/// The plan of a UAV at some moment. Revisions count from 1 at the node's start.
struct PlanReport {
  std::uint64_t revision = 0;
  MissionTime made;
  std::vector<PlannedTask> tasks;  ///< tasks of unsettled goals
  std::vector<GoalStatus> goals;   ///< all, in the order of the high-level plan; settled ones first
  bool operator==(const PlanReport&) const = default;
};

}  // namespace skein::mission
