// SPDX-License-Identifier: Apache-2.0
// Operator 5: gives high-level tasks to the executive, each as a whole, when they come near.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "book/outbox.hpp"
#include "commitment/joint_tasks.hpp"
#include "jobs/agenda.hpp"
#include "schedule/dates.hpp"

namespace skein::supervisor {

/// Gives tasks to the executive, updates their conditions, and aborts them. Lifetime: refers to its
/// arguments.
class Committer {
 public:
  /// `horizon`: a high-level task is given when it may start within this.
  Committer(const world::VehicleModel& vehicle, Duration horizon, const Agenda& agenda,
            Dates& dates, Outbox& out, Book& book);

  /// Gives the goals that are due, unless the plan is being repaired.
  void commit();
  /// Whether any task was ever given.
  bool ever_gave() const { return ever_gave_; }
  std::optional<GoalId> next_to_give() const;
  /// When the goal is to be given; absent while that is not known.
  std::optional<MissionTime> due(GoalId goal) const;
  /// The goal's start is bounded by the end of another goal that has not ended yet.
  bool is_undated(GoalId goal) const;

  /// Updates the dates, and the conditions of tasks at the executive that change with them.
  void reschedule();
  void send_preconditions(Entry& entry);
  /// The conditions of the tasks that need the vehicle and have not begun.
  void renew_motions();
  void stop(const std::vector<TaskId>& tasks);
  /// Withdraws the tasks of these goals, and has the executive abort those that it has.
  void retire(const std::set<GoalId>& goals);

  /// Gives the executive a task of no goal; returns its id.
  TaskId start_loose(const std::string& type);
  TaskId start_safe_wait();
  void stop_safe_waits();
  /// When a safe wait is to end so that the first task that the executive has may begin in time.
  std::optional<MissionTime> end_of_safe_wait() const;

  JointTasks& joint_tasks() { return joint_tasks_; }

 private:
  MissionTime now() const { return out_.now(); }
  void give(GoalId goal);
  mission::ElementaryTask as_given(const mission::ElementaryTask& task) const;
  std::set<TaskId> loose_before(const mission::ElementaryTask& task) const;
  void end_waits(const std::vector<TaskId>& waits);
  Duration safe_wait_ends_within() const;
  void abort(TaskId id);
  /// Another executive has the task: it is told when it is back.
  bool is_told_later(Entry& entry) const;
  void tell_what_is_back();

  const world::VehicleModel& vehicle_;
  Duration horizon_;
  const Agenda& agenda_;
  Dates& dates_;
  Outbox& out_;
  Book& book_;
  JointTasks joint_tasks_;
  bool ever_gave_ = false;
};

}  // namespace skein::supervisor
