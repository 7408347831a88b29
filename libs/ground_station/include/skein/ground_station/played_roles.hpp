// SPDX-License-Identifier: Apache-2.0
// Roles of joint tasks that the ground plays for UAVs.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// Which roles are played. One stays until its task is told to be over, however often it is asked
/// to stop. Deterministic. A value; not safe to share between threads. Cost: O(log n) in the roles,
/// but O(n) of stop() for all roles of a UAV.
class PlayedRoles {
 public:
  void play(const PlayRole& play);
  /// Notes a state of the task; returns it as what the board is told.
  TaskEventReceived note(const PlayedTaskChanged& changed);
  /// For whatever is played for the UAV; absent: nothing is.
  std::optional<StopRole> stop(const std::string& uav, const std::string& why) const;
  /// Absent: the request is not an ABORT of a task that is played.
  std::optional<StopRole> stop(const SendRequest& request) const;

 private:
  std::set<std::pair<std::string, executive::TaskId>> played_;  ///< joint tasks, by UAV
};

}  // namespace skein::ground_station
