// SPDX-License-Identifier: Apache-2.0
// Plans that UAVs handed over and that nobody carries out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// What was only planned when a UAV's degree went below 4 waits here until an operator resumes,
/// edits or drops it. A value; not safe to share between threads. Source: spec 1.2.
class HeldPlans {
 public:
  /// The tasks come on top of what is held already; one that is held is replaced. Gives how many
  /// are held now.
  std::size_t hold(const std::string& uav, const std::vector<mission::HeldTask>& tasks);
  /// In the order of ids.
  std::vector<mission::HeldTask> of(const std::string& uav) const;
  /// All but `without`, which are discarded; nothing is held then. What waited for a discarded task
  /// waits for what that one waited for.
  std::vector<mission::HeldTask> take(const std::string& uav,
                                      const std::vector<executive::TaskId>& without);
  /// Discards all; gives how many there were.
  std::size_t drop(const std::string& uav);
  /// Discards the tasks of one high-level task, as `take` does; gives how many there were.
  std::size_t drop(const std::string& uav, mission::GoalId goal);

  struct Answer {
    bool accepted = true;
    std::string why = {};
    std::size_t dropped = 0;  ///< tasks
  };
  /// A request about a task that is held edits the plan: ABORT and SUPPRESS discard the task,
  /// UPDATE-COND changes its conditions; START of its id is refused. Nothing: about no such task.
  std::optional<Answer> edit(const std::string& uav, const Request& request);

 private:
  using Plan = std::map<executive::TaskId, mission::HeldTask>;
  static void discard(Plan& plan, executive::TaskId id);

  std::map<std::string, Plan> plans_;
};

}  // namespace skein::ground_station
