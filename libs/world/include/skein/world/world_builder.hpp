// SPDX-License-Identifier: Apache-2.0
// Makes a World from the content of a world file.
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
/// Height of the airspace above the highest ground if the file gives no ceiling [m].
inline constexpr double kDefaultAir = 300;

/// The cells of the ground state over a terrain. Precondition: problems_of(terrain) is empty.
Grid ground_grid(const GroundRequest& ground, const TerrainSpec& terrain);

/// Makes the world, or returns all errors: a raster or geodetic place that geodata has not resolved
/// before, airspace or ground of too many cells or without extent, fires outside the ground.
Result<World, Diagnostics> build_world(WorldFile file);

}  // namespace skein::world
