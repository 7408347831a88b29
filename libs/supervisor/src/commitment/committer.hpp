// SPDX-License-Identifier: Apache-2.0
// Operator 5: high-level tasks go to the executive as a whole as they come near.
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

/// What the executive is given, told and made to stop. Lifetime: refers to its arguments.
class Committer {
 public:
  /// `horizon`: a high-level task is given when it may start within this.
  Committer(const world::VehicleModel& vehicle, Duration horizon, const Agenda& agenda,
            Dates& dates, Outbox& out, Book& book);

  /// Gives what is due, unless the plan is being repaired.
  void commit();
  /// True when something was ever given.
  bool ever_gave() const { return ever_gave_; }
  std::optional<GoalId> next_to_give() const;
  /// When; nothing while that is not known.
  std::optional<MissionTime> due(GoalId goal) const;
  /// It begins some time after the end of another goal, which is to come.
  bool is_undated(GoalId goal) const;

  /// Makes the dates anew, and tells the executive what they change for it.
  void reschedule();
  void send_preconditions(Entry& entry);
  void stop(const std::vector<TaskId>& tasks);
  /// These goals lose their tasks.
  void retire(const std::set<GoalId>& goals);

  /// A task of no goal; returns its number.
  TaskId start_loose(const std::string& type);
  TaskId start_safe_wait();
  void stop_safe_waits();
  /// When a safe wait is to end, so that the first of the tasks that the executive has may begin in
  /// time.
  std::optional<MissionTime> end_of_safe_wait() const;

  JointTasks& joint_tasks() { return joint_tasks_; }

 private:
  MissionTime now() const { return out_.now(); }
  void give(GoalId goal);
  mission::ElementaryTask as_given(const mission::ElementaryTask& task) const;
  std::set<TaskId> loose_before(const mission::ElementaryTask& task) const;
  void end_waits(const std::vector<TaskId>& waits);
  Duration safe_wait_ends_within() const;

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
