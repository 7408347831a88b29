// SPDX-License-Identifier: Apache-2.0
// Path planning over the ground, for ground vehicles.
#pragma once

#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// The terrain as a map: one layer of voxels around height 0. A voxel is free if the vehicle can
/// drive everywhere in it and in its neighbours: no slope steeper than the model's limit, and no
/// volume that reaches down to the vehicle. Voxels subdivide the terrain's cells, less finely on
/// larger terrain. A free segment between two points of the layer can be driven.
/// Precondition: vehicle.ground. Cost: O(voxels × (1 + volumes)), up to a million voxels.
world::Airspace drivable_ground(const world::Terrain& terrain, const world::VehicleModel& vehicle,
                                const std::vector<world::Volume>& volumes, double margin = 0);

/// The point of that place on the map of drivable_ground().
inline world::Vector3 on_map(const world::Vector3& at) { return {at.x(), at.y(), 0}; }
/// The point of the ground at these coordinates.
world::Vector3 on_ground(const world::Terrain& terrain, const world::Vector3& at);

/// The path draped over the ground, with points between the given ones: for lengths, times and
/// energies.
Way draped(const Way& way, const world::Terrain& terrain);

/// Plans paths over such a map; their points are on the ground. A place that is not free on the map
/// is joined to the nearest free one, if that is near and the ground between is not too steep, so
/// that a vehicle inside a volume can leave it. Refused: `to` on ground that is too steep or
/// outside the terrain, an end that cannot be joined to the map (kBlocked); no path (kUnreachable).
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
