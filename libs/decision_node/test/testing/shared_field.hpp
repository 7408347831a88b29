// SPDX-License-Identifier: Apache-2.0
// A field in two halves, shared between "heron" and "wren".
#pragma once

#include <memory>
#include <utility>

#include "interaction/area_share.hpp"
#include "testing/level_ground.hpp"
#include "testing/mapping_vehicle.hpp"

namespace skein::decision_node::testing {

inline const world::Polygon kWest = {{0, 0}, {200, 0}, {200, 200}, {0, 200}};
inline const world::Polygon kEast = {{200, 0}, {400, 0}, {400, 200}, {200, 200}};

inline interaction::Rows agreed(const world::Polygon& heron, const world::Polygon& wren) {
  return {interaction::row_of("heron", heron), interaction::row_of("wren", wren)};
}

/// Heron over level ground, with a camera that looks 30 m to each side from 60 m up.
inline SweepSetting setting_at(const world::Vector3& position, double energy = 1) {
  world::WorldFile file = level_ground(1000);
  file.airspace.ceiling = 150;
  supervisor::Knowledge knowledge;
  knowledge.uav = "heron";
  knowledge.altitude = 60;
  knowledge.vehicle.cruise_speed = 8;
  make_map(knowledge.vehicle);
  SweepSetting setting{
      std::make_shared<const supervisor::Knowledge>(knowledge),
      std::make_shared<const world::World>(world::build_world(std::move(file)).value()),
      MissionTime(),
      {},
      "mapping"};
  setting.state.position = position;
  setting.state.energy = energy;
  setting.state.airborne = true;
  return setting;
}

}  // namespace skein::decision_node::testing
