// SPDX-License-Identifier: Apache-2.0
// Measured ground as a file of the project's own, which daemons read without a library of maps.
#pragma once

#include <string>
#include <string_view>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/terrain.hpp"

namespace skein::world {

/// Measured ground, where on Earth it lies and where it comes from.
struct MeasuredTerrain {
  GeodeticOrigin origin;
  std::string source;   ///< for people: the raster it was made from
  TerrainSpec terrain;  ///< with elevations, without hills
};

/// The text of a terrain file: a YAML head (`skein_terrain: 1`, source, origin, west, south, east,
/// north, cell), a line `---`, then a line per row of corners, the northern row first, each with
/// its elevations from west to east [m over the origin's level], rounded up to a centimetre so that
/// nothing that was planned over the ground comes closer to it.
/// Precondition: `measured.terrain` has elevations and no problems_of().
/// Cost: some 0.1 µs a corner.
std::string terrain_file_text(const MeasuredTerrain& measured);

/// The ground of a terrain file. Refused, each with its line: another format or version, a head
/// that lacks something, rows or elevations too many or too few (the first twenty), what is no
/// elevation, a terrain that problems_of() refuses. `file` is only used in the messages.
Result<MeasuredTerrain, Diagnostics> read_terrain_file(std::string_view text,
                                                       const std::string& file);

}  // namespace skein::world
