// SPDX-License-Identifier: Apache-2.0
// Connectivity of free voxels.
#pragma once

#include <optional>

#include "skein/refiners/budget.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Whether two free voxels are connected over faces, by a flood fill from the first; nothing if the
/// other is not met within `most` voxels, or the time is up. Far cheaper than a search that
/// exhausts the airspace. Memory: one bit per voxel.
std::optional<bool> connected(const world::Airspace& airspace, const world::Voxel& from,
                              const world::Voxel& to, std::size_t most, const Budget& budget);

}  // namespace skein::refiners
