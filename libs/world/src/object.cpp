// SPDX-License-Identifier: Apache-2.0
#include "skein/world/object.hpp"

#include <algorithm>

namespace skein::world {
namespace {

Vector2 along_way(const WorldObject& object, double distance) {
  Vector2 at = object.position;
  for (const Vector2& next : object.waypoints) {
    const double leg = (next - at).norm();
    if (distance < leg) return at + (next - at) * (distance / leg);
    distance -= leg;
    at = next;
  }
  return at;
}

}  // namespace

bool is_active(const WorldObject& object, MissionTime at) {
  return at >= object.appears && at < object.disappears;
}

FireFront front_of(const WorldObject& object, MissionTime at) {
  return front_of(*object.spread, object.position, object.radius, at - object.appears);
}

Vector3 position_at(const WorldObject& object, MissionTime at, const Terrain& terrain) {
  const double age = std::max(0.0, (at - object.appears).to_seconds());
  const Vector2 ground =
      object.spread ? front_of(object, at).centre() : along_way(object, age * object.speed);
  return {ground.x(), ground.y(), terrain.elevation(ground.x(), ground.y()) + object.height};
}

}  // namespace skein::world
