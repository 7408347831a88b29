// SPDX-License-Identifier: Apache-2.0
// The sensors of one vehicle and their tasks.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "sensing.hpp"
#include "skein/elementary/task_checks.hpp"
#include "status_board.hpp"

namespace skein::sim {

using elementary::TakeshotTask;

/// Each device runs at most one task. A task takes its first look at once, then one per period of
/// its device, until it is interrupted, or its duration or number of shots is reached.
class SensorSuite {
 public:
  SensorSuite(const world::VehicleModel& model, const std::string& uav, std::uint64_t seed);

  /// Why the device cannot start; nothing if it can.
  std::optional<std::string> refusal(const std::string& device) const;
  void start(TaskId id, TakeshotTask task, MissionTime now, StatusBoard& board,
             std::vector<Effect>& effects);
  /// False when no such task runs here.
  bool interrupt(TaskId id, MissionTime now, StatusBoard& board, std::vector<Effect>& effects);
  void abort_all(const std::string& reason, MissionTime now, StatusBoard& board,
                 std::vector<Effect>& effects);
  /// False when no such task runs here.
  bool abort(TaskId id, const std::string& reason, MissionTime now, StatusBoard& board,
             std::vector<Effect>& effects);
  /// The task other than `but` that has run longest.
  std::optional<TaskId> oldest(std::optional<TaskId> but) const;
  bool runs(TaskId id) const;
  void break_device(const std::string& device, MissionTime now, StatusBoard& board,
                    std::vector<Effect>& effects);
  /// Takes the looks that are due.
  void step(const world::VehicleState& state, double pointing_error, const Scene& scene,
            MissionTime now, StatusBoard& board, std::vector<Effect>& effects);

  const std::set<std::string>& broken() const { return broken_; }
  /// The target of the first running task that has one.
  std::optional<world::Vector2> target() const;

 private:
  struct Shot {
    TaskId id;
    TakeshotTask task;
    MissionTime next;
    MissionTime until;
    std::uint64_t left;  ///< shots
  };

  world::VehicleModel model_;
  std::map<std::string, Random> randoms_;  ///< by device, so that devices do not affect each other
  std::set<std::string> broken_;
  std::vector<Shot> shots_;
};

}  // namespace skein::sim
