// SPDX-License-Identifier: Apache-2.0
// Geometry of zones for patterns flown over them.
#pragma once

#include "refinery/motion.hpp"
#include "skein/world/world.hpp"

namespace skein::supervisor {

struct Box {
  world::Vector2 low, high;
  double least_side() const { return (high - low).minCoeff(); }
};
Box box_of(const world::Polygon& polygon);

/// Mean of the corners.
world::Vector2 middle_of(const world::Polygon& polygon);
/// Heading from `from` towards middle_of() [rad].
double heading_to(const world::Vector3& from, const world::Polygon& polygon);
/// A grid over the zone's bounding box, as fine as `footprint` [m] asks for, with the known risks.
world::GroundState ground_over(const world::Polygon& polygon, const world::GroundState& known,
                               double footprint);
/// Radius of the ground disc that a device looking down sees from a height [m]; error: none.
Answer<double> footprint(const world::SensorModel& device, double height);

}  // namespace skein::supervisor
