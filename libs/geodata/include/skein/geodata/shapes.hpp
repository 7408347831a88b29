// SPDX-License-Identifier: Apache-2.0
// Areas and ways in the files of other programs: GeoJSON, KML, WKT.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/geometry.hpp"

namespace skein::geodata {

/// A polygon of a file in the local frame [m]; rings without their closing corner.
struct Shape {
  std::string name;  ///< of its feature; may be empty
  world::Polygon outer;
  std::vector<world::Polygon> holes;
};

/// Most polygons of a file.
inline constexpr std::size_t kMostShapes = 10'000;

/// The polygons of a file, those of a multipolygon one by one, in their order; whatever else is in
/// it is left out. By its ending: .geojson, .json and .kml, in the coordinates that they say
/// (longitude and latitude if nothing else); .wkt, one geometry a line, in metres of the local
/// frame unless `crs` says in what ("EPSG:4326": longitude, latitude). Heights are left out.
/// Refused: a file that is missing, damaged, of another format, without a polygon, or with a `crs`
/// where it says its own. Never writes or prints anything, never asks the network.
Result<std::vector<Shape>, Diagnostics> read_shapes(const std::string& path,
                                                    const world::GeodeticOrigin& origin,
                                                    const std::string& crs = "");

/// Something to be written.
struct Feature {
  enum class Kind { kPoint, kLine, kPolygon };
  Kind kind = Kind::kPoint;
  std::string name;
  std::vector<world::Vector3> points;  ///< [m], ENU; of a polygon without the closing corner
};

/// Writes a new file: .geojson, .json and .kml in longitude, latitude and height over the
/// ellipsoid, .wkt (one geometry a line) in metres of the local frame. Refused: another ending, a
/// place that cannot be written.
Result<void, Diagnostics> write_features(const std::string& path,
                                         const std::vector<Feature>& features,
                                         const world::GeodeticOrigin& origin);

}  // namespace skein::geodata
