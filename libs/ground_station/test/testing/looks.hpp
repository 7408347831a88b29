// SPDX-License-Identifier: Apache-2.0
// Looks of devices at a fire.
#pragma once

#include <string>

#include "skein/world/perception.hpp"

namespace skein::ground_station::testing {

inline const world::Vector3 kFire(100, 50, 0);

/// A look straight down at a place from 60 m, which sees 60 m around.
inline world::Perception look(const std::string& uav, const std::string& device, double at,
                              const world::Vector3& above = kFire) {
  world::Perception perception;
  perception.uav = uav;
  perception.device = device;
  perception.viewpoint = above + world::Vector3(5, 0, 60);
  perception.direction = -world::Vector3::UnitZ();
  perception.range = 150;
  perception.aperture = 0.8;
  perception.at = MissionTime::seconds(at);
  return perception;
}

inline world::Perception seeing(world::Perception perception, const std::string& kind,
                                const world::Vector3& at = kFire, double spread = 5) {
  perception.detections.push_back({kind, at, spread, 0.9});
  return perception;
}

}  // namespace skein::ground_station::testing
