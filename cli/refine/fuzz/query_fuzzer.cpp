// SPDX-License-Identifier: Apache-2.0
// Any text as a query: read, or refused with reasons; never anything else.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "query_reader.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/world/world_builder.hpp"

namespace {

using namespace skein;  // NOLINT(google-build-using-namespace): a single function

template <class T>
Result<T, Diagnostics> no_file(const std::string& file) {
  Diagnostics diagnostics;
  Diagnostic one;
  one.file = file;
  one.message = "there are no files here";
  diagnostics.add(one);
  return tl::make_unexpected(diagnostics);
}

/// Building the voxels and cells of large worlds is not what is tested here.
Result<world::World, Diagnostics> small_world(world::WorldFile file) {
  const auto* spec = std::get_if<world::TerrainSpec>(&file.terrain);
  if (spec == nullptr ||
      (spec->east - spec->west) * (spec->north - spec->south) > 1e5 * spec->cell * spec->cell)
    return no_file<world::World>("a large world");
  return world::build_world(std::move(file));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const refine_tool::References references{no_file<world::World>, small_world,
                                           no_file<world::VehicleModel>};
  const auto query = refine_tool::read_query(text, "fuzz", references);
  SKEIN_ENSURES(query || !query.error().empty());
  return 0;
}
