// SPDX-License-Identifier: Apache-2.0
// Tasks that look: the camera's trigger once a period.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "skein/elementary/task_checks.hpp"
#include "status_board.hpp"

namespace skein::autopilot {

/// Each device runs at most one task. A picture that the camera acknowledges is a look that
/// detected nothing: who finds something in the pictures is not known here. One that it refuses
/// aborts the task.
class Looks {
 public:
  explicit Looks(const BridgeConfig& config) : config_(config) {}

  /// Why the device cannot start; absent if it can.
  std::optional<std::string> refusal(const std::string& device) const;
  void start(TaskId id, elementary::TakeshotTask task, Duration now, StatusBoard& board,
             Outbox& out);
  /// False when no such task runs here.
  bool abort(TaskId id, const std::string& reason, StatusBoard& board, Outbox& out);
  void abort_all(const std::string& reason, StatusBoard& board, Outbox& out);
  bool runs(TaskId id) const;
  void hear(const Commands::Outcome& outcome, const world::VehicleState& state, StatusBoard& board,
            Outbox& out);
  /// Takes the pictures that are due of the vehicle of this system.
  void step(std::uint8_t system, Duration now, Commands& commands, StatusBoard& board, Outbox& out);

 private:
  struct Shot {
    TaskId id;
    elementary::TakeshotTask task;
    Duration next;
    Duration until;
    std::uint64_t left;                           ///< pictures
    std::optional<Commands::Ticket> ticket = {};  ///< of the picture that is being taken
  };
  Command trigger(std::uint8_t system);

  const BridgeConfig& config_;
  std::vector<Shot> shots_;
  std::uint32_t pictures_ = 0;
};

}  // namespace skein::autopilot
