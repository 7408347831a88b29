// SPDX-License-Identifier: Apache-2.0
// The part of an airspace from where radio contact can be kept.
#pragma once

#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"
#include "skein/world/world.hpp"

namespace skein::refiners {

/// The places that a vehicle can talk to: `with`, and the relays that have a chain of links to it.
std::vector<world::Vector3> anchors_of(const Contact& contact, const world::World& world);

/// Closes every voxel unless one and the same anchor has a link, RadioModel::link(…, false), to all
/// of its points. Exact, not sampled: the farthest corner of the voxel is in reach, and no ground
/// stands in the pyramid between the anchor and the voxel's bottom (what sees a point sees what is
/// above it). So there is contact at each point of a way through the voxels left.
/// Cost: a horizon for each corner of the voxels' columns in reach, and for each column the corners
/// of the ground between it and the anchor. False when the time is up before: then the voxels left
/// are not these.
bool keep_contact(world::Airspace& airspace, const std::vector<world::Vector3>& anchors,
                  const world::World& world, const Budget& budget = {});

}  // namespace skein::refiners
