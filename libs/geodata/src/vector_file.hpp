// SPDX-License-Identifier: Apache-2.0
// What reading and writing files of shapes have in common.
#pragma once

#include <ogr_spatialref.h>

#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"

namespace skein::geodata {

enum class VectorFormat { kGeoJson, kKml, kWkt, kUnknown };
/// By the ending of a path.
VectorFormat vector_format_of(const std::string& path);
/// GDAL's name of the format; null for those that are not its.
const char* driver_of(VectorFormat format);
/// Makes those formats known to GDAL, once.
void register_vector_formats();

/// Longitude, latitude in degrees.
OGRSpatialReference longitude_latitude();

/// The refusal of a file.
tl::unexpected<Diagnostics> wrong_file(const std::string& path, std::string message,
                                       std::string expected = "");

inline constexpr const char* kEndings = "a file that ends with .geojson, .json, .kml or .wkt";

}  // namespace skein::geodata
