// SPDX-License-Identifier: Apache-2.0
// Simulation of one look of one sensor: geometry and random detection.
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

/// The terrain and the objects that sensors may see.
struct Scene {
  const world::Terrain& terrain;
  const std::vector<world::WorldObject>& objects;
};

/// True if the object is active and in view, and the terrain does not hide its top. A spreading
/// fire is visible if some point of its front is.
bool is_visible(const world::View& view, const world::WorldObject& object, MissionTime at,
                const world::Terrain& terrain);

/// Quality with which an object is perceived, [0, 1], at its nearest part:
/// world::perceived_quality, so that planners and simulator agree. An object on the ground is
/// inclined as the ground is; an object above it has no surface of its own. 1 from within the
/// object. Depends on the range, but not on the direction of the view.
double quality_of(const world::SensorModel& sensor, const world::Vector3& viewpoint,
                  const world::WorldObject& object, MissionTime at, const world::Terrain& terrain);

/// One look: each visible object of a known kind is detected with the probability of its kind times
/// its quality, at a position with the sensor's spread. A spreading fire is detected at the point
/// of its front that is nearest to the line of view. False alarms are added, on the ground in view
/// if there is any.
std::vector<world::Detection> look(const world::SensorModel& sensor, const world::View& view,
                                   const Scene& scene, MissionTime at, Random& random);

}  // namespace skein::sim
