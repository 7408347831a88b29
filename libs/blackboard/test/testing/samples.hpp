// SPDX-License-Identifier: Apache-2.0
// Samples of each class, as small as they may be.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard::testing {

inline wire::TaskEvent task_event(std::uint64_t id) {
  wire::TaskEvent event;
  event.uav = "marvin";
  event.id = id;
  event.type = "goto";
  return event;
}

inline wire::SyncMessage sync_message(std::uint64_t id) {
  wire::SyncMessage message;
  message.id = id;
  return message;
}

/// Of about so many bytes, all of which depend on the id.
inline wire::HandOver hand_over(std::uint64_t id, std::size_t bytes) {
  constexpr std::size_t kStatement = 8'000;
  wire::HandOver event;
  event.uav = "marvin";
  do {
    wire::GoalEntry& goal = event.goals.emplace_back();
    goal.id = id;
    goal.statement.resize(std::min(bytes, kStatement));
    for (std::size_t i = 0; i < goal.statement.size(); ++i)
      goal.statement[i] = static_cast<char>('a' + (i * i + id + event.goals.size()) % 26);
    bytes -= goal.statement.size();
  } while (bytes > 0);
  return event;
}

inline wire::AutonomyDegree degree(std::uint8_t value) {
  wire::AutonomyDegree degree;
  degree.uav = "marvin";
  degree.degree = value;
  return degree;
}

inline wire::Telemetry telemetry(double energy) {
  wire::Telemetry telemetry;
  telemetry.uav = "marvin";
  telemetry.energy = static_cast<float>(energy);
  return telemetry;
}

}  // namespace skein::blackboard::testing
