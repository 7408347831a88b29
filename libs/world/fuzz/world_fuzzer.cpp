// SPDX-License-Identifier: Apache-2.0
// No text, however wrong, may crash the reading of a world file or the making of its world.
#include <cstdint>
#include <string_view>

#include "skein/foundation/contract.hpp"
#include "skein/world/world_builder.hpp"
#include "skein/world/world_reader.hpp"

namespace {

/// Worlds that are right, yet take long to make, would only slow the search for wrong ones.
bool small(const skein::world::WorldFile& file) {
  const auto* terrain = std::get_if<skein::world::TerrainSpec>(&file.terrain);
  if (terrain == nullptr) return true;
  const auto cells = static_cast<double>(skein::world::corners_of(*terrain).count());
  const auto ground = static_cast<double>(skein::world::ground_grid(file.ground, *terrain).size());
  return cells * static_cast<double>(terrain->hills.size() + 1) < 1e6 && ground < 1e5;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  auto file = skein::world::read_world_file(text, "fuzz");
  SKEIN_ENSURES(file.has_value() || !file.error().empty());
  if (!file || !small(*file)) return 0;
  const auto world = skein::world::build_world(std::move(*file));
  SKEIN_ENSURES(world.has_value() || !world.error().empty());
  return 0;
}
