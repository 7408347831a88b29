// SPDX-License-Identifier: Apache-2.0
// Figures of cells as raster files for other programs.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/grid.hpp"

namespace skein::geodata {

/// What cells that have no value have in files.
inline constexpr double kNoValue = -9999;

/// True for an ending that write_raster knows: .tif, .tiff or .asc.
bool is_raster_name(const std::string& path);

/// Writes a new file, .tif (GeoTIFF) or .asc (ESRI ASCII grid, with a .prj beside it), in metres
/// around the origin (azimuthal equidistant, which differs from the local plane by 4 mm at 10 km);
/// NaN is written as kNoValue, and declared so. `values`: one per cell, row-major from the
/// south-west. Refused: another ending, a place that cannot be written.
Result<void, Diagnostics> write_raster(const std::string& path, const world::Grid& grid,
                                       const std::vector<double>& values,
                                       const world::GeodeticOrigin& origin);

}  // namespace skein::geodata
