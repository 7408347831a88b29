// SPDX-License-Identifier: Apache-2.0
#include "vector_file.hpp"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace skein::geodata {

VectorFormat vector_format_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".geojson" || ending == ".json") return VectorFormat::kGeoJson;
  if (ending == ".kml") return VectorFormat::kKml;
  return ending == ".wkt" ? VectorFormat::kWkt : VectorFormat::kUnknown;
}

const char* driver_of(VectorFormat format) {
  if (format == VectorFormat::kGeoJson) return "GeoJSON";
  return format == VectorFormat::kKml ? "KML" : nullptr;
}

void register_vector_formats() {
  static const bool registered = [] {
    RegisterOGRGeoJSON();
    RegisterOGRKML();
    return true;
  }();
  static_cast<void>(registered);
}

OGRSpatialReference longitude_latitude() {
  OGRSpatialReference reference;
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  reference.importFromEPSG(4326);
  return reference;
}

tl::unexpected<Diagnostics> wrong_file(const std::string& path, std::string message,
                                       std::string expected) {
  Diagnostics diagnostics;
  diagnostics.add({path, 0, 0, "", std::move(message), std::move(expected), ""});
  return tl::make_unexpected(std::move(diagnostics));
}

}  // namespace skein::geodata
