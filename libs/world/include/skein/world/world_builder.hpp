// SPDX-License-Identifier: Apache-2.0
// From what a world file says to the world.
#pragma once

#include <cstddef>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/world.hpp"
#include "skein/world/world_file.hpp"

namespace skein::world {

/// Most voxels of an airspace whose file gives no voxel size.
inline constexpr std::size_t kDefaultVoxels = 8'000'000;
/// Most cells of a GroundState from a file.
inline constexpr double kMostGroundCells = 4e6;
/// What the air of a file that gives no ceiling reaches above the highest ground [m].
inline constexpr double kDefaultAir = 300;

/// The cells of the ground state over a terrain. Precondition: problems_of(terrain) is empty.
Grid ground_grid(const GroundRequest& ground, const TerrainSpec& terrain);

/// The world, or why there is none: a raster or a place on Earth that was not resolved (only
/// geodata does that), airspace or ground of too many cells or without extent, fires off the
/// ground. Every error at once.
Result<World, Diagnostics> build_world(WorldFile file);

}  // namespace skein::world
