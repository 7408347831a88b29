// SPDX-License-Identifier: Apache-2.0
// A plan of elementary tasks, as deliberation makes it and as others are shown it.
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

/// What a task waits for of another one.
enum class DependenceKind : std::uint8_t {
  kEnded,    ///< it has ended, and not been aborted
  kRunning,  ///< it is running
  kOver,     ///< it has ended or was aborted: for what takes the place of a withdrawn task
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

/// Who begin a joint task together, the same at all of them.
struct Gathering {
  std::uint64_t id = 0;              ///< follows from the task, what it is about and its members
  std::vector<std::string> members;  ///< in order of their names
  bool agreed = false;               ///< when it begins
  bool operator==(const Gathering&) const = default;
};

/// (type, id, dependences, start, duration, time constraints, parameters, origin).
/// Source: T def. IV.2, spec 3.4.
struct ElementaryTask {
  executive::TaskId id;
  /// As the registry of task types has it: takeoff, goto, perceive, joint:NAME, …
  std::string type;
  std::string name;                  ///< as the domain and the seeds have it: "task-gotoxyz"
  executive::Parameters parameters;  ///< as the functional layer takes them
  std::optional<executive::Synchronisation> synchronisation;
  std::optional<Gathering> gathering;  ///< of a joint task
  std::vector<Dependence> dependences;
  /// Dependences of its stop-task: what ends it (stop-takeshot, stop-wait). Source: spec 2.7.
  std::vector<Dependence> stop;
  Interval start;  ///< relative to the plan's origin
  /// How long nature may take. [0, 0] with `stop`: as long as that says.
  Interval duration;
  bool open_ended = false;  ///< until orders come: without stop and without bound
  TimeConstraints time;
  GoalId origin;                     ///< the high-level task it comes from
  std::vector<world::Vector3> way;   ///< where it flies [m] ENU; empty: it does not
  std::vector<std::string> methods;  ///< labels, from the high-level task down to this one
  double energy = 0;                 ///< expected, as a fraction of what is held when full
  double cost = 0;                   ///< as the domain has it
  bool operator==(const ElementaryTask&) const = default;
};

/// What the registry says of it.
const functional::TaskType& type_of(const ElementaryTask& task);
/// True for what moves the vehicle or needs it where it is.
bool holds_vehicle(const ElementaryTask& task);
/// The devices that are its own while it is active.
std::vector<std::string> devices_of(const ElementaryTask& task);

/// Individual and joint tasks of one UAV in the order of planning. Source: T def. IV.1.
struct ElementaryPlan {
  MissionTime origin;  ///< what the relative starts count from
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

/// Between which dates a task is to start and end, as the network of the plan has it now.
struct TaskDates {
  MissionTime earliest_start, latest_start;  ///< latest may be MissionTime::max()
  MissionTime earliest_end, latest_end;
  bool operator==(const TaskDates&) const = default;
};

/// A task as others are shown it.
struct PlannedTask {
  ElementaryTask task;
  TaskDates dates;
  bool committed = false;  ///< the executive has it
  bool operator==(const PlannedTask&) const = default;
};

/// The plan of a UAV at some moment. Revisions count from 1 in one life of the node.
struct PlanReport {
  std::uint64_t revision = 0;
  MissionTime made;
  std::vector<PlannedTask> tasks;  ///< those of goals that are not settled
  std::vector<GoalStatus> goals;   ///< all, in the order of the high-level plan; settled ones first
  bool operator==(const PlanReport&) const = default;
};

}  // namespace skein::mission
