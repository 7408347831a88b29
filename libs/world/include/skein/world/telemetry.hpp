// SPDX-License-Identifier: Apache-2.0
// What a vehicle tells of itself.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::world {

/// Among the failed devices: the engine.
inline constexpr const char* kEngineDevice = "engine";

/// Once per telemetry period.
struct Telemetry {
  std::string uav;
  VehicleState state;
  MissionTime at;                        ///< when it was so
  std::vector<std::string> failed = {};  ///< devices that do not work, by name; kEngineDevice too
  bool operator==(const Telemetry&) const = default;
};

}  // namespace skein::world
