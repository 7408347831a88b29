// SPDX-License-Identifier: Apache-2.0
// Things in the world that sensors may see: fires, vehicles, smoke.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/fire.hpp"
#include "skein/world/terrain.hpp"

namespace skein::world {

/// Something on the ground. Kinds are open: "fire", "hot-vehicle", "smoke", any name.
struct WorldObject {
  std::string name;
  std::string kind;
  Vector2 position = Vector2::Zero();  ///< where it appears [m]
  double height = 0;                   ///< of its centre above the ground [m], >= 0
  double radius = 0;                   ///< [m], >= 0
  MissionTime appears;
  MissionTime disappears = MissionTime::max();
  /// It moves along these at `speed`, from the instant it appears, then stays; empty: it never
  /// moves.
  std::vector<Vector2> waypoints;
  double speed = 0;  ///< over the ground [m/s], >= 0
  /// A fire that grows from where and when it appears, `radius` ahead of there at first.
  std::optional<FireSpread> spread = {};
  bool operator==(const WorldObject&) const = default;
};

/// From the instant it appears until just before it disappears.
bool is_active(const WorldObject& object, MissionTime at);

/// What burns of a fire that spreads, at an instant from when it appears. Precondition: it spreads.
FireFront front_of(const WorldObject& object, MissionTime at);

/// Its centre at an instant; before it appears, where it will. Cost: O(waypoints).
Vector3 position_at(const WorldObject& object, MissionTime at, const Terrain& terrain);

}  // namespace skein::world
