// SPDX-License-Identifier: Apache-2.0
// Durations of lanes and of the turns between them.
#pragma once

#include <optional>

#include "skein/refiners/dubins.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

/// A lane with its direction of flight. The heading is explicit since a lane may have no length.
struct Pass {
  world::Vector2 from = world::Vector2::Zero(), to = world::Vector2::Zero();
  double heading = 0;  ///< [rad]

  Pose begin() const { return {from, heading}; }
  Pose end() const { return {to, heading}; }
};

/// Durations [s] in still air and level flight.
///
/// A hovering vehicle flies every lane and every transfer from rest to rest, within its speed and
/// acceleration, and turns towards the next lane during the transfer. The legs from the start and
/// to the end may have any heading. Other vehicles fly at constant speed on shortest curves of
/// their turn radius; they may leave the start and reach the end with any heading. Constant cost
/// each. Lifetime: the vehicle must outlive it. Precondition: check_vehicle passes, speed > 0.
class TurnModel {
 public:
  TurnModel(const world::VehicleModel& vehicle, double speed);

  double along(double length) const;
  /// Duration of a lane along x of the sweep frame (`forth`) or against it, in the wind.
  double lane(double length, bool forth) const {
    return along(length) + length * (forth ? lost_forth_ : lost_back_);
  }
  /// The same model in a wind [m/s] in the sweep frame (the part that moves the vehicle), which
  /// only counts along the lanes. Precondition: less than the speed.
  TurnModel in_wind(const world::Vector2& wind) const;
  /// Duration from the end of one lane to the beginning of another, in the sweep frame (headings 0
  /// or π).
  double between(const Pass& from, const Pass& to) const;
  /// Duration of the turn from the end of a lane to the beginning of an aligned lane at `spacing`
  /// in the opposite direction.
  double beside(double spacing) const;
  double reach(const world::Vector2& start, const Pass& first) const;
  double leave(const Pass& last, const world::Vector2& end) const;

  bool hovers() const { return hovers_; }
  double speed() const { return speed_; }
  double radius() const { return radius_; }
  const world::VehicleModel& vehicle() const { return *vehicle_; }
  /// Upper bound on the time that a stop adds to flight at constant speed.
  double stop() const { return hovers_ ? speed_ / acceleration_ : 0; }

 private:
  const world::VehicleModel* vehicle_;
  bool hovers_;
  double speed_, acceleration_, yaw_rate_, radius_;
  double lost_forth_ = 0, lost_back_ = 0;  // [s/m]
};

/// The shortest curve from a point, with any heading there, to a pose.
DubinsCurve arrival(const world::Vector2& from, const Pose& to, double radius);
/// The shortest curve from a pose to a point, with any heading there.
DubinsCurve departure(const Pose& from, const world::Vector2& to, double radius);

}  // namespace skein::refiners
