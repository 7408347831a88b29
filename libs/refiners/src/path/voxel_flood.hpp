// SPDX-License-Identifier: Apache-2.0
// Whether free voxels hang together.
#pragma once

#include <optional>

#include "skein/refiners/budget.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Whether a way over faces joins two free voxels, by a flood from the first; nothing when it has
/// not met the other within `most` voxels, or the time is up. Far cheaper than a search that has to
/// exhaust the air. Memory: a bit a voxel.
std::optional<bool> connected(const world::Airspace& airspace, const world::Voxel& from,
                              const world::Voxel& to, std::size_t most, const Budget& budget);

}  // namespace skein::refiners
