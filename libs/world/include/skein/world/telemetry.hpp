// SPDX-License-Identifier: Apache-2.0
// Telemetry of a vehicle.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::world {

/// The name of the engine in Telemetry::failed.
inline constexpr const char* kEngineDevice = "engine";

/// Once per telemetry period.
struct Telemetry {
  std::string uav;
  VehicleState state;
  MissionTime at;                        ///< instant of `state`
  std::vector<std::string> failed = {};  ///< devices that do not work, by name; kEngineDevice too
  bool operator==(const Telemetry&) const = default;
};

}  // namespace skein::world
