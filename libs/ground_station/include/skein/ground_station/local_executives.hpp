// SPDX-License-Identifier: Apache-2.0
// The executives that run at the ground for UAVs at degree 1.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/executive/executive.hpp"
#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// Those that run, and what is known of each besides its tasks: whether it was told that its UAV
/// flies, and of which goals its tasks are. One begins to run when it is first asked for.
/// Deterministic. Not safe to share between threads. Cost of each call: O(log n) in the UAVs, and
/// O(tasks of the UAV) where tasks are gone through.
class LocalExecutives {
 public:
  /// `configs`: by UAV. Precondition of what names a UAV: it is one of them.
  explicit LocalExecutives(std::map<std::string, executive::Config> configs);

  bool can_run(const std::string& uav) const { return configs_.contains(uav); }
  bool runs(const std::string& uav) const { return running_.contains(uav); }
  /// UAVs whose executive runs here, by name.
  std::vector<std::string> running() const;
  /// Those of them whose executive has something to do at `now`.
  std::vector<std::string> due(MissionTime now) const;
  std::optional<MissionTime> next_wakeup() const;

  /// The UAV's executive, which runs from now on. Valid until let_go().
  executive::Executive& of(const std::string& uav);
  /// Whether an executive of the UAV runs here that knows the task.
  bool knows(const std::string& uav, executive::TaskId task) const;

  /// Notes whether the UAV flies; returns whether its executive has to be told.
  bool note_flight(const std::string& uav, bool airborne);
  /// The task, which was transferred to here, is one of the goal's.
  void note_origin(const std::string& uav, executive::TaskId task, mission::GoalId goal);
  /// The goal's tasks here that are not over, by id.
  std::vector<executive::TaskId> open_tasks_of(const std::string& uav, mission::GoalId goal) const;

  /// The request that begins a task; what the executive will have given up without an answer
  /// expires.
  SendFunctional to_begin(const std::string& uav, executive::TaskId task, MissionTime now);
  SendFunctional to_interrupt(const std::string& uav, executive::TaskId task);
  /// Of each task that the functional layer has under way the request that it was last sent, which
  /// does not expire.
  std::vector<SendFunctional> under_way(const std::string& uav);

  /// The executive runs here no longer. Returns its tasks that are not over, except those of the
  /// background routine, by id. Precondition: runs(uav).
  std::vector<mission::HeldTask> let_go(const std::string& uav);

 private:
  struct Local {
    executive::Executive executive;
    std::optional<bool> airborne;                               ///< as last told to it
    std::map<executive::TaskId, mission::GoalId> origins = {};  ///< goals of transferred tasks
  };
  Local& local(const std::string& uav);
  SendFunctional functional_of(const std::string& uav, functional::Verb verb,
                               executive::TaskId task);

  std::map<std::string, executive::Config> configs_;
  std::map<std::string, Local> running_;
};

}  // namespace skein::ground_station
