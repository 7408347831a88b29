// SPDX-License-Identifier: Apache-2.0
// Ground elevation and burning risk from raster files, on local grids.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/grid.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/world_file.hpp"

namespace skein::geodata {

struct ElevationOptions {
  /// Absent: the middle of the raster, at the lowest elevation that is read.
  std::optional<world::GeodeticOrigin> origin;
  std::optional<double> cell;           ///< [m], > 0; absent: as fine as the raster, or as
                                        ///< four million corners allow
  std::optional<world::Extent> extent;  ///< [m], ENU; absent: the largest upright rectangle covered
  std::optional<double> no_data;        ///< elevation for cells without data [m]; absent: refused
  /// For a raster that does not say in which coordinates it is ("EPSG:4326"); empty: refused.
  /// One that says another than this is refused too.
  std::string crs;
  /// Corners are raised until no post of the raster stands out of the ground between them: what is
  /// planned over it stays above the raster at any size of cell.
  bool above_posts = false;
  /// Posts of the raster that are held at most (4 bytes each), >= 1. Of larger rasters blocks of
  /// posts are taken as one: see Elevation::decimated.
  std::size_t most_posts = 32'000'000;
};

struct Elevation {
  world::TerrainSpec terrain;  ///< usable: problems_of() is empty
  world::GeodeticOrigin origin;
  /// By how much corners are above what the raster says there, because of `above_posts` [m].
  double raised_most = 0, raised_mean = 0;
  /// So many posts of the raster along each side count as one, which is as high as the highest of
  /// them and of those in the blocks around: such ground is never below the raster between corners
  /// that are `above_posts`, and stands over it by what the raster falls in so many posts.
  int decimated = 1;
};

/// Reads a GeoTIFF, an ESRI ASCII grid or an SRTM tile (.hgt), in WGS 84 or any geographic or
/// projected coordinates. Its heights are taken as heights over the ellipsoid: where they are over
/// the geoid, as most are, origin.altitude is to be given likewise. Each corner of the local grid
/// is looked up where it really is on Earth, so that the ground bends away from the local plane as
/// the Earth does; bilinear between the middles of the raster's cells, level within half a cell of
/// its border. Refused, each naming the file: a file that is missing, damaged or of another format,
/// unknown or unusable projections, an extent beyond the raster, cells without data, figures that
/// are no elevations, too many cells. Never writes or prints anything, never asks the network.
/// Cost: the part of the raster that is needed is read once and held, decimated where it is larger
/// than ElevationOptions::most_posts; some 2 µs for each corner of the terrain. Safe from any
/// thread.
Result<Elevation, Diagnostics> read_elevation(const std::string& path,
                                              const ElevationOptions& options = {});

struct RiskOptions {
  std::optional<double> no_data;  ///< risk of cells without data, [0, 1]; absent: refused
  std::string crs;                ///< as for elevations
};

/// Burning risk at the middle of each cell of a local grid, at the level of the origin; read as
/// elevations are. Values outside [0, 1] are refused.
Result<std::vector<double>, Diagnostics> read_risk(const std::string& path, const world::Grid& grid,
                                                   const world::GeodeticOrigin& origin,
                                                   const RiskOptions& options = {});

}  // namespace skein::geodata
