// SPDX-License-Identifier: Apache-2.0
// Samples of each class, as small as they may be.
#pragma once

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

inline wire::AutonomyDegree degree(std::uint8_t value) {
  wire::AutonomyDegree degree;
  degree.uav = "marvin";
  degree.degree = value;
  return degree;
}

inline wire::Telemetry telemetry(double energy) {
  wire::Telemetry telemetry;
  telemetry.uav = "marvin";
  telemetry.energy = energy;
  return telemetry;
}

}  // namespace skein::blackboard::testing
