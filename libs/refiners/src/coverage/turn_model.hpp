// SPDX-License-Identifier: Apache-2.0
// What lanes and the turns between them take a vehicle.
#pragma once

#include <optional>

#include "skein/refiners/dubins.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

/// A lane as it is flown. The heading is that from one end to the other, and is given since a lane
/// may have no length.
struct Pass {
  world::Vector2 from = world::Vector2::Zero(), to = world::Vector2::Zero();
  double heading = 0;  ///< [rad]

  Pose begin() const { return {from, heading}; }
  Pose end() const { return {to, heading}; }
};

/// Seconds, in still air and level flight.
///
/// A vehicle that hovers flies every lane and every move from rest to rest, at no more than its
/// speed and acceleration; while it moves over it turns towards the next lane. The moves from the
/// start and to the end are flown with any heading.
/// One that does not flies all of it at its speed, on shortest curves of its turn radius; it may
/// come from the start, and arrive at the end, with any heading.
/// Constant cost each. Lifetime: the vehicle must outlive it. Precondition: check_vehicle passes,
/// speed > 0.
class TurnModel {
 public:
  TurnModel(const world::VehicleModel& vehicle, double speed);

  double along(double length) const;
  /// A lane flown along x of the sweep frame or back, in the wind.
  double lane(double length, bool forth) const {
    return along(length) + length * (forth ? lost_forth_ : lost_back_);
  }
  /// The same in a wind, as far as it moves the vehicle [m/s], in the sweep frame; it only counts
  /// along the lanes. Precondition: less than the speed.
  TurnModel in_wind(const world::Vector2& wind) const;
  /// Both in the sweep frame: headings are 0 or π.
  double between(const Pass& from, const Pass& to) const;
  /// From the end of a lane to the beginning of one `spacing` beside it, level with it, in the
  /// opposite sense.
  double beside(double spacing) const;
  double reach(const world::Vector2& start, const Pass& first) const;
  double leave(const Pass& last, const world::Vector2& end) const;

  bool hovers() const { return hovers_; }
  double speed() const { return speed_; }
  double radius() const { return radius_; }
  const world::VehicleModel& vehicle() const { return *vehicle_; }
  /// What a stop adds to flying on at speed, at most.
  double stop() const { return hovers_ ? speed_ / acceleration_ : 0; }

 private:
  const world::VehicleModel* vehicle_;
  bool hovers_;
  double speed_, acceleration_, yaw_rate_, radius_;
  double lost_forth_ = 0, lost_back_ = 0;  // [s/m]
};

/// The shortest curve that arrives at a pose from a point, with any heading there.
DubinsCurve arrival(const world::Vector2& from, const Pose& to, double radius);
/// The same backwards.
DubinsCurve departure(const Pose& from, const world::Vector2& to, double radius);

}  // namespace skein::refiners
