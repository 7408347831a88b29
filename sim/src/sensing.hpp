// SPDX-License-Identifier: Apache-2.0
// What one look of one sensor detects, by geometry and by chance.
#pragma once

#include <optional>
#include <vector>

#include "skein/elementary/view_of.hpp"
#include "skein/foundation/random.hpp"
#include "skein/world/object.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/sensor_model.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::sim {

using elementary::view_of;

/// What there is to see.
struct Scene {
  const world::Terrain& terrain;
  const std::vector<world::WorldObject>& objects;
};

/// True when the object is there, in view, and the terrain does not hide its top. Of a fire that
/// spreads: some place of its front.
bool is_visible(const world::View& view, const world::WorldObject& object, MissionTime at,
                const world::Terrain& terrain);

/// How well an object is perceived, [0, 1], by the part of it that is nearest: what distance and
/// incidence leave, as world::perceived_quality has it, so that who plans a view and who simulates
/// it agree. An object that lies on the ground is inclined as the ground is; one over it has no
/// surface of its own. 1 from within the object. Within the range, whatever the view says.
double quality_of(const world::SensorModel& sensor, const world::Vector3& viewpoint,
                  const world::WorldObject& object, MissionTime at, const world::Terrain& terrain);

/// One look: each visible object of a known kind is detected with its probability times the quality
/// with which it is perceived, at a place with the sensor's spread. Of a fire that spreads it is
/// the place of its front that is nearest to where the sensor looks. False alarms come on top, on
/// the ground in view where there is some.
std::vector<world::Detection> look(const world::SensorModel& sensor, const world::View& view,
                                   const Scene& scene, MissionTime at, Random& random);

}  // namespace skein::sim
