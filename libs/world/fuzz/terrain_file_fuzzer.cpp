// SPDX-License-Identifier: Apache-2.0
// No text, however wrong, may crash the reading of a terrain file; ground that was read can be
// used, and written and read again.
#include <cstdint>
#include <string_view>

#include "skein/foundation/contract.hpp"
#include "skein/world/terrain_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace skein::world;  // NOLINT(google-build-using-namespace): its readers
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto measured = read_terrain_file(text, "fuzz");
  SKEIN_ENSURES(measured.has_value() || !measured.error().empty());
  if (!measured) return 0;
  const Terrain terrain(measured->terrain);
  SKEIN_ENSURES(terrain.elevation(measured->terrain.east, measured->terrain.north) <= 1e5);
  const auto again = read_terrain_file(terrain_file_text(*measured), "again");
  SKEIN_ENSURES(again.has_value());
  SKEIN_ENSURES(again->terrain.elevations.size() == measured->terrain.elevations.size());
  return 0;
}
