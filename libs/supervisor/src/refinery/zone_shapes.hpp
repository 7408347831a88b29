// SPDX-License-Identifier: Apache-2.0
// Zones as patterns over them need them.
#pragma once

#include "refinery/motion.hpp"
#include "skein/world/world.hpp"

namespace skein::supervisor {

struct Box {
  world::Vector2 low, high;
  double least_side() const { return (high - low).minCoeff(); }
};
Box box_of(const world::Polygon& polygon);

/// Of its corners.
world::Vector2 middle_of(const world::Polygon& polygon);
/// Towards its middle [rad].
double heading_to(const world::Vector3& from, const world::Polygon& polygon);
/// A grid over the zone's box, as fine as the footprint, with the risks that are known.
world::GroundState ground_over(const world::Polygon& polygon, const world::GroundState& known,
                               double footprint);
/// Radius of what a device that looks down sees from a height at once [m].
Answer<double> footprint(const world::SensorModel& device, double height);

}  // namespace skein::supervisor
