// SPDX-License-Identifier: Apache-2.0
// Plans that UAVs handed over and that nobody carries out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// Keeps the tasks that were only planned when a UAV's degree went below 4, until an operator
/// resumes, edits or drops them. A value; not safe to share between threads. Source: spec 1.2.
class HeldPlans {
 public:
  /// Adds the tasks to those held; a task with the same id is replaced. Returns how many tasks of
  /// the UAV are held now.
  std::size_t hold(const std::string& uav, const std::vector<mission::HeldTask>& tasks);
  /// The held tasks of the UAV, by id.
  std::vector<mission::HeldTask> of(const std::string& uav) const;
  /// Removes and returns the held tasks, except `without`, which are discarded: a task that waited
  /// for a discarded one waits for the predecessors of that.
  std::vector<mission::HeldTask> take(const std::string& uav,
                                      const std::vector<executive::TaskId>& without);
  /// Discards all held tasks; returns how many there were.
  std::size_t drop(const std::string& uav);
  /// Discards the tasks of one high-level task, as take() does; returns how many there were.
  std::size_t drop(const std::string& uav, mission::GoalId goal);

  struct Answer {
    bool accepted = true;
    std::string why = {};
    std::size_t dropped = 0;  ///< tasks
  };
  /// Applies a request about a held task: ABORT and SUPPRESS discard the task, UPDATE-COND changes
  /// its conditions, START with its id is refused. Absent: the request is not about a held task.
  std::optional<Answer> edit(const std::string& uav, const Request& request);

 private:
  using Plan = std::map<executive::TaskId, mission::HeldTask>;
  static void discard(Plan& plan, executive::TaskId id);

  std::map<std::string, Plan> plans_;
};

}  // namespace skein::ground_station
