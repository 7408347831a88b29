// SPDX-License-Identifier: Apache-2.0
// What one look of a sensor gave.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"

namespace skein::world {

struct Detection {
  std::string kind;                    ///< what the sensor takes it for; may be wrong
  Vector3 position = Vector3::Zero();  ///< estimate [m], ENU
  double spread = 0;                   ///< standard deviation of the estimate, per axis [m]
  double confidence = 0;               ///< [0, 1]
  bool operator==(const Detection&) const = default;
};

/// One look, with where it looked: a look without detections says something too.
struct Perception {
  std::string uav;
  std::string device;
  Vector3 viewpoint = Vector3::Zero();
  Vector3 direction = Vector3::UnitX();  ///< boresight, unit length
  double range = 0;                      ///< [m]
  double aperture = 0;                   ///< half angle of the cone [rad]
  std::vector<Detection> detections;
  MissionTime at;
  bool operator==(const Perception&) const = default;
};

}  // namespace skein::world
