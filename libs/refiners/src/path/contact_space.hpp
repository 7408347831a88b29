// SPDX-License-Identifier: Apache-2.0
// The part of an airspace from where radio contact can be kept.
#pragma once

#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"
#include "skein/world/world.hpp"

namespace skein::refiners {

/// The nodes for direct contact: `with`, and the relays that have a chain of links to it.
std::vector<world::Vector3> anchors_of(const Contact& contact, const world::World& world);

/// Closes every voxel unless a single anchor has a link, RadioModel::link(…, false), to all of its
/// points. Exact, not sampled: the farthest corner of the voxel is in range, and no ground is in
/// the pyramid between the anchor and the voxel's bottom (an anchor that sees a point sees all
/// above it). So there is contact at each point of a path through the remaining voxels. Cost: a
/// horizon for each corner of the voxels' columns in range, and for each column the corners of the
/// ground between it and the anchor. False if the time is up before: the result is then incomplete.
bool keep_contact(world::Airspace& airspace, const std::vector<world::Vector3>& anchors,
                  const world::World& world, const Budget& budget = {});

}  // namespace skein::refiners
