// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of shapes, GeoJSON, KML or WKT by how they begin: read or refused with a
// reason; what is read is finite, and can be written and read again.
#include <cmath>

#include "read_fuzzed.hpp"
#include "skein/geodata/shapes.hpp"

namespace {

using namespace skein::geodata;  // NOLINT(google-build-using-namespace): what is fuzzed

std::string ending_of(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (byte == '{') return ".geojson";
    if (byte == '<') return ".kml";
    if (byte > ' ') break;
  }
  return ".wkt";
}

void look_at(const skein::world::Polygon& ring) {
  for (const skein::world::Vector2& corner : ring) require(corner.allFinite());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const skein::world::GeodeticOrigin origin{37.3, -6, 150};
  const std::string path = file_of({data, size}, ending_of({data, size}));
  const bool degrees = size % 2 == 1 && path.ends_with(".wkt");
  const auto shapes = read_shapes(path, origin, degrees ? "EPSG:4326" : "");
  require(shapes.has_value() || !shapes.error().empty());
  if (!shapes) return 0;
  require(!shapes->empty() && shapes->size() <= kMostShapes);
  for (const Shape& shape : *shapes) {
    look_at(shape.outer);
    for (const skein::world::Polygon& hole : shape.holes) look_at(hole);
  }
  return 0;
}
