// SPDX-License-Identifier: Apache-2.0
// Where a vehicle that was stopped in flight circles, as it is seen to.
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "skein/foundation/time.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// A disc and the heights that a vehicle has stayed in for a whole turn [m].
struct Circle {
  world::Vector2 center;
  double radius = 0;
  double lowest = 0, highest = 0;
};

/// Looks on until the vehicle has flown a turn without getting farther off than a circle is wide.
class Circling {
 public:
  /// `radius`: of its circles, at the most [m].
  explicit Circling(double radius) : radius_(radius) {}

  /// `now` never decreases.
  void see(const world::VehicleState& state, MissionTime now);
  /// Nothing: it has not flown a turn yet.
  std::optional<Circle> seen() const;

 private:
  double radius_;
  Eigen::AlignedBox3d around_;  ///< of the places seen since `flown_` was 0
  double flown_ = 0;            ///< [m]
  MissionTime last_;
};

}  // namespace skein::decision_node
