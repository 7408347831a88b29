// SPDX-License-Identifier: Apache-2.0
// Estimates the wind from the drift of a vehicle.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "skein/foundation/time.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/vehicle_state.hpp"
#include "skein/world/wind.hpp"

namespace skein::supervisor {

/// A Kalman filter of mean wind and airspeed. In steady flight the ground velocity is the airspeed
/// in the direction of the heading plus a share of the wind (VehicleModel::wind_drift). Straight
/// flight shows only the crosswind; along the track, wind and airspeed are separable only after a
/// turn. The filter starts from the believed wind and the cruise speed, both uncertain. It ignores
/// states in hover, during acceleration, braking, climb or descent, and in turns of a hovering
/// vehicle, whose heading may lag behind.
///
/// Deterministic; a value type. Cost of a state: some hundred operations.
class WindEstimator {
 public:
  WindEstimator(const world::VehicleModel& vehicle, const world::Wind& believed);

  /// Precondition: `at` never decreases.
  void see(const world::VehicleState& state, MissionTime at);

  /// The estimated mean wind, with the gusts of the believed wind.
  world::Wind wind() const;
  /// Greatest standard deviation of the mean wind in any direction [m/s].
  double spread() const;

 private:
  bool is_steady(const world::VehicleState& state, double dt) const;

  bool hovers_;
  double cruise_, drift_, gusts_;
  Eigen::Vector3d mean_;  ///< wind east, north, air speed [m/s]
  Eigen::Matrix3d covariance_;
  std::optional<world::VehicleState> last_;
  MissionTime last_at_;
};

}  // namespace skein::supervisor
