// SPDX-License-Identifier: Apache-2.0
// Who flies: how soon an order takes effect and how far from the meant place it is flown.
#pragma once

#include "skein/foundation/random.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::sim {

/// The autopilot, or the person of a teleoperated vehicle. What is flown is offset from what is
/// meant by an error drawn anew at each correction: every attention period of a person, every 5 s
/// of an autopilot (its navigation wanders). Errors are cut at two deviations.
class Pilot {
 public:
  Pilot(const world::VehicleModel& model, Random random);

  /// From an order to its effect; zero for an autopilot.
  Duration reaction();
  /// Draws the errors anew if a correction is due.
  void attend(MissionTime now);
  /// Of the place that is flown to [m].
  const world::Vector3& position_error() const { return position_error_; }
  /// Of the heading that is flown, and of a sensor that is pointed by hand [rad].
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
