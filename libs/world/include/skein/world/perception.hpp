// SPDX-License-Identifier: Apache-2.0
// The result of one look of a sensor.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"

namespace skein::world {

struct Detection {
  std::string kind;                    ///< as classified by the sensor; may be wrong
  Vector3 position = Vector3::Zero();  ///< estimate [m], ENU
  double spread = 0;                   ///< standard deviation of the estimate, per axis [m]
  double confidence = 0;               ///< [0, 1]
  bool operator==(const Detection&) const = default;
};

/// One look and its view cone; looks without detections are evidence, too.
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
