// SPDX-License-Identifier: Apache-2.0
// From a place to the voxels.
#pragma once

#include <optional>

#include "path/space.hpp"

namespace skein::refiners {

/// How to get from a place that is free itself, though its voxel is not wholly so, to a free voxel:
/// through voxels of an eighth of the side, around the place only. So that near the ground what
/// counts is how high the place is, not the highest ground of its voxel.
struct Approach {
  world::Voxel voxel{};  ///< where it joins the graph
  Way way;               ///< from the place to the voxel's centre; the place alone when it is in it
  std::optional<world::Airspace> near;  ///< the fine voxels; nothing when they were not needed
};

/// `toward`: the other end of the way; voxels on its side are preferred. Nothing when the place is
/// closed, or the time is up.
std::optional<Approach> approach(const PathSpace& space, const world::Airspace& airspace,
                                 const world::Vector3& place, const world::Vector3& toward,
                                 const Budget& budget);

}  // namespace skein::refiners
