// SPDX-License-Identifier: Apache-2.0
// How the vehicle is when a motion that is planned begins.
#pragma once

#include <optional>
#include <vector>

#include "flight/autopilot.hpp"
#include "refinery/motion.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::supervisor {

/// As far as it is known: passing a place in flight, or on the ground. A value.
class VehicleStart {
 public:
  explicit VehicleStart(const world::VehicleModel& vehicle) : vehicle_(vehicle) {}

  /// The vehicle is passing `from` now with that heading [rad]: a motion that begins there within
  /// some seconds begins in flight.
  void flies_on(const world::Vector3& from, double heading);
  /// Whether a motion with this departure begins in flight; if it departs later, the vehicle
  /// circles first.
  bool in_flight(const Departure& when) const;
  /// The vehicle stands on the ground at `at`.
  void stands_at(const world::Vector3& at) { stand_ = at; }
  const std::optional<world::Vector3>& stand() const { return stand_; }
  /// How a motion from there may begin, if it may begin `in_flight`; as poses_at().
  std::vector<Pose> poses(const world::Vector3& from, bool in_flight, int headings = 4) const;

 private:
  world::VehicleModel vehicle_;
  std::optional<world::Vector3> stand_;
  std::vector<Pose> passing_;  ///< possible ones of a motion that begins in flight
};

}  // namespace skein::supervisor
