// SPDX-License-Identifier: Apache-2.0
// Any bytes as an ESRI ASCII grid: read or refused with a reason; ground that was read can be used.
#include <algorithm>

#include "read_fuzzed.hpp"
#include "skein/geodata/raster_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace skein::geodata;  // NOLINT(google-build-using-namespace): what is fuzzed
  const std::string path = file_of({data, size}, ".asc");
  ElevationOptions options;
  options.crs = size % 2 == 0 ? "EPSG:4326" : "EPSG:32630";
  options.above_posts = size % 4 >= 2;
  options.most_posts = 10'000;
  options.cell = 100;
  if (size % 3 == 0) options.no_data = 0;
  const auto read = read_elevation(path, options);
  require(read.has_value() || !read.error().empty());
  if (!read) return 0;
  require(skein::world::problems_of(read->terrain).empty());
  const skein::world::Terrain terrain(read->terrain);
  require(terrain.elevation(0, 0) <= 1e6);
  return 0;
}
