// SPDX-License-Identifier: Apache-2.0
// Joins a place to the voxel graph.
#pragma once

#include <optional>

#include "path/space.hpp"

namespace skein::refiners {

/// The path from a free place in a voxel that is not entirely free to a free voxel, through voxels
/// of an eighth of the side around the place. Near the ground the height of the place itself thus
/// counts, not the highest ground in its voxel.
struct Approach {
  world::Voxel voxel{};  ///< where it joins the graph
  Way way;               ///< from the place to the voxel's centre; only the place if inside it
  std::optional<world::Airspace> near;  ///< the fine voxels; nothing if they were not needed
};

/// `toward`: the other end of the way; voxels on its side are preferred. Nothing when the place is
/// closed, or the time is up.
std::optional<Approach> approach(const PathSpace& space, const world::Airspace& airspace,
                                 const world::Vector3& place, const world::Vector3& toward,
                                 const Budget& budget);

}  // namespace skein::refiners
