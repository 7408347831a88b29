// SPDX-License-Identifier: Apache-2.0
// The wind, from how it carries a vehicle that flies by itself over the ground.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "skein/foundation/time.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/vehicle_state.hpp"
#include "skein/world/wind.hpp"

namespace skein::supervisor {

/// A Kalman filter of mean wind and air speed. Where the vehicle flies steadily its velocity over
/// the ground is its air speed in the direction of its nose, and its share of the wind
/// (VehicleModel::wind_drift). Straight flight tells the wind across it; along it wind and air
/// speed cannot be told apart until the vehicle turns. Starts from the wind believed and the cruise
/// speed, both uncertain. States in hover, in turns that a hovering vehicle's nose may lag behind,
/// while it gathers speed or brakes, climbs or descends tell nothing and are left out.
///
/// Deterministic; a value type. Cost of a state: some hundred operations.
class WindEstimator {
 public:
  WindEstimator(const world::VehicleModel& vehicle, const world::Wind& believed);

  /// Precondition: `at` never decreases.
  void see(const world::VehicleState& state, MissionTime at);

  /// With the gusts that were believed.
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
