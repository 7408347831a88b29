// SPDX-License-Identifier: Apache-2.0
// Objects in the world that sensors may detect: fires, vehicles, smoke.
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
  /// The object moves along these points at `speed` from its appearance on, and stays at the last;
  /// empty: it never moves.
  std::vector<Vector2> waypoints;
  double speed = 0;  ///< over the ground [m/s], >= 0
  /// Present: a fire that spreads from its appearance on; its head is `radius` ahead at first.
  std::optional<FireSpread> spread = {};
  bool operator==(const WorldObject&) const = default;
};

/// Whether `at` is in [appears, disappears).
bool is_active(const WorldObject& object, MissionTime at);

/// The front of a spreading fire, for instants from its appearance on. Precondition: it spreads.
FireFront front_of(const WorldObject& object, MissionTime at);

/// The centre of the object at an instant; before its appearance, where it will appear. Cost:
/// O(waypoints).
Vector3 position_at(const WorldObject& object, MissionTime at, const Terrain& terrain);

}  // namespace skein::world
