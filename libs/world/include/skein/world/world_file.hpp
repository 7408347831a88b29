// SPDX-License-Identifier: Apache-2.0
// The content of a world file, before its rasters are read and its geodetic places are projected.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/world/geodetic.hpp"
#include "skein/world/radio_model.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/volume.hpp"
#include "skein/world/wind.hpp"
#include "skein/world/zone.hpp"

namespace skein::world {

/// Position in the file, for errors that are found later.
struct Mark {
  int line = 0;      ///< from 1
  std::string path;  ///< "terrain.raster"
};

/// A rectangle of the ground [m], ENU.
struct Extent {
  double west = 0, south = 0, east = 0, north = 0;
  bool operator==(const Extent&) const = default;
};

/// A raster file that is to be read.
struct RasterSource {
  std::string file;  ///< as written: relative to the folder of the world file
  /// Coordinate reference system of a raster that does not say ("EPSG:4326"); empty: not given.
  std::string crs;
  std::optional<double> no_data;  ///< takes the place of cells without data
  Mark mark;
};

struct RasterTerrain {
  RasterSource raster;
  std::optional<double> cell;    ///< [m]; absent: as fine as the raster
  std::optional<Extent> extent;  ///< absent: all that the raster covers
};

/// A peak of the burning risk, which falls off with distance like a HillSpec.
struct RiskPeak {
  Vector2 at = Vector2::Zero();
  double risk = 1;    ///< in the middle, [0, 1]
  double radius = 0;  ///< beyond it, none of it is left [m], > 0
};

/// The risk is the highest of the peaks at each place, and at least `base`.
struct RiskPeaks {
  double base = 0;  ///< [0, 1]
  std::vector<RiskPeak> peaks;
};

/// One per cell of the ground's grid, as GroundState has it.
using RiskCells = std::vector<double>;

struct GroundRequest {
  std::optional<double> cell;  ///< [m]; absent: 50, or larger where that were too many
  std::variant<double, RiskPeaks, RasterSource, RiskCells> risk = 0.5;
  std::vector<Polygon> mapped;
  std::vector<Vector2> alarms, fires;
  Mark mark;
};

/// The requested voxel grid; absent values follow from the terrain.
struct AirspaceRequest {
  std::optional<double> west, south, east, north, floor, ceiling;  ///< [m]
  std::optional<double> voxel;                                     ///< [m]
  Mark mark;
};

struct Place {
  std::variant<Vector3, GeodeticPoint> at;
  Mark mark;
};

/// The result of read_world_file(). Geodata then resolves rasters (`terrain` to a TerrainSpec, risk
/// to RiskCells), a missing origin, and geodetic places to local points; build_world() makes a
/// World of the result.
struct WorldFile {
  std::string file;                      ///< name for messages
  std::optional<GeodeticOrigin> origin;  ///< absent: that of the raster
  std::variant<TerrainSpec, RasterTerrain> terrain;
  Wind wind;
  AirspaceRequest airspace;
  std::vector<Volume> volumes;
  GroundRequest ground;
  RadioModel radio;
  std::vector<Zone> zones;
  std::map<std::string, Place, std::less<>> places;
};

}  // namespace skein::world
