// SPDX-License-Identifier: Apache-2.0
// How far the missions of a UAV are.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/byte_book.hpp"
#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// What was told of the goals and missions of one UAV: each state of a goal once, and each stage of
/// a mission once between restarts. A value; not safe to share between threads. Cost: O(goals).
class MissionProgress {
 public:
  using Change = std::variant<GoalChanged, MissionChanged>;

  /// `goals`, which are shown, become `told`, if nothing later was told. Returns what is new.
  std::vector<Change> take(const std::string& uav, std::vector<mission::GoalStatus>& goals,
                           const std::vector<mission::GoalStatus>& told,
                           std::optional<MissionTime> at);
  /// Absent: it was told.
  std::optional<MissionChanged> stage(const std::string& uav, mission::MissionId mission,
                                      MissionStage stage);
  /// The UAV's node restarted: what stages it had told counts no longer.
  void restart() { told_.clear(); }

 private:
  ByteBook told_;                  ///< of missions, a bit for each stage
  std::optional<MissionTime> at_;  ///< time of the goals taken last
};

}  // namespace skein::ground_station
