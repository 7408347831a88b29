// SPDX-License-Identifier: Apache-2.0
// Requests for elementary tasks: what they say, and whether the vehicle can do it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"
#include "skein/functional/parameters.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::elementary {

/// Least height above the ground of any way-point [m].
inline constexpr double kLeastHeight = 2;

struct TakeoffTask {
  double height;  ///< to reach, ENU z [m]
};
struct LandTask {};
struct GotoTask {
  std::vector<world::Vector3> waypoints;
  double speed;  ///< [m/s]
};
struct WaitTask {
  std::optional<Duration> duration;  ///< absent: until interrupted
};
struct TakeshotTask {
  std::string device;
  std::optional<world::Vector3> target;
  std::optional<Duration> duration;
  std::optional<std::uint64_t> shots;
};
/// Looks from where the vehicle is, which stays there.
struct PerceiveTask {
  TakeshotTask shot;
};
using ElementaryTask =
    std::variant<TakeoffTask, LandTask, GotoTask, WaitTask, TakeshotTask, PerceiveTask>;

/// What a request is checked against.
struct Situation {
  const world::VehicleModel& model;
  const world::Terrain& terrain;
  const world::VehicleState& state;
  bool engine_works;
};

/// The task, or every reason why the vehicle cannot do it, joined by "; ". What runs already is not
/// looked at here.
Result<ElementaryTask, Failure> checked_task(const std::string& type,
                                             const functional::Parameters& parameters,
                                             const Situation& situation);

}  // namespace skein::elementary
