// SPDX-License-Identifier: Apache-2.0
// Ways over the ground, for vehicles that keep to it.
#pragma once

#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// The terrain seen from above, as one layer of voxels around height 0. Free is a voxel when the
/// vehicle can drive everywhere in it and in those around it: nowhere steeper than its model says,
/// and out of the volumes that reach down to it there. Voxels are parts of the terrain's cells,
/// coarser ones the larger it is. A free segment between two points of the layer can be driven.
/// Precondition: vehicle.ground. Cost: O(voxels × (1 + volumes)), up to a million voxels.
world::Airspace drivable_ground(const world::Terrain& terrain, const world::VehicleModel& vehicle,
                                const std::vector<world::Volume>& volumes, double margin = 0);

/// Where that place is on the map that drivable_ground() makes.
inline world::Vector3 on_map(const world::Vector3& at) { return {at.x(), at.y(), 0}; }
/// On the ground there.
world::Vector3 on_ground(const world::Terrain& terrain, const world::Vector3& at);

/// The way with the heights of the ground between its points, as it is driven: for lengths, times
/// and energies.
Way draped(const Way& way, const world::Terrain& terrain);

/// Ways over such a map; the points of a way are on the ground. A place that is not free on the map
/// is joined to the nearest one that is, if that is near and the ground between is not too steep:
/// who stands in a volume leaves it. Refused: `to` on ground that is too steep or outside the
/// terrain, an end that nothing near it joins to the map (kBlocked); no way (kUnreachable).
/// Lifetime: the map outlives the planner.
class DrivingPlanner final : public PathPlanner {
 public:
  explicit DrivingPlanner(const world::Airspace& map) : map_(map) {}
  explicit DrivingPlanner(world::Airspace&&) = delete;

  Outcome<Path> plan(const PathQuery& query, const Setting& setting) const override;

 private:
  const world::Airspace& map_;
};

}  // namespace skein::refiners
