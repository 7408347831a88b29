// SPDX-License-Identifier: Apache-2.0
// Reaction time and flying errors of the autopilot or pilot.
#pragma once

#include "skein/foundation/random.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::sim {

/// The autopilot, or the human pilot of a teleoperated vehicle. The flown position and heading are
/// offset from the intended ones by errors that are drawn anew at each correction: every attention
/// period of a human pilot, every 5 s of an autopilot (drift of its navigation). Errors are limited
/// to two standard deviations.
class Pilot {
 public:
  Pilot(const world::VehicleModel& model, Random random);

  /// A random reaction time, from an order to its effect; zero for an autopilot.
  Duration reaction();
  /// Draws the errors anew if a correction is due.
  void attend(MissionTime now);
  /// Error of the flown position [m].
  const world::Vector3& position_error() const { return position_error_; }
  /// Error of the flown heading, and of the direction of a sensor that is pointed by hand [rad].
  double heading_error() const { return heading_error_; }

 private:
  double bounded_normal();

  world::VehicleModel model_;
  Duration period_;
  MissionTime next_;
  world::Vector3 position_error_ = world::Vector3::Zero();
  double heading_error_ = 0;
  Random random_;
};

}  // namespace skein::sim
