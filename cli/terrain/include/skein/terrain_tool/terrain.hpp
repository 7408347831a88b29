// SPDX-License-Identifier: Apache-2.0
// `skein terrain`: measured ground for scenarios.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace skein::terrain_tool {

struct MakeOptions {
  std::string raster;          ///< GeoTIFF, ESRI ASCII grid, SRTM tile
  std::string out;             ///< the terrain file
  std::optional<double> cell;  ///< [m]; absent: as fine as the raster
  /// West, south, east, north [m]; empty: the largest upright rectangle that the raster covers.
  std::vector<double> extent;
  /// Latitude, longitude [degrees], altitude [m]; empty: the raster's middle, at its lowest.
  std::vector<double> origin;
  std::string crs;                ///< of a raster that does not say it
  std::optional<double> no_data;  ///< elevation of cells without data [m]
};

/// Reads the raster and writes the terrain file. Returns an exit code (docs/exit-codes.md).
int make_terrain(const MakeOptions& options, std::ostream& out, std::ostream& err);

struct ShowOptions {
  std::string file;
  std::string svg;  ///< a picture of it; empty: none
};

/// Says where it lies, how large, high and steep it is. Returns an exit code.
int show_terrain(const ShowOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::terrain_tool
