// SPDX-License-Identifier: Apache-2.0
// Query files (JSON; being a part of YAML, with comments if one likes).
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "query.hpp"
#include "skein/config/reader.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/geodata/shapes.hpp"
#include "skein/world/world_file.hpp"

namespace skein::refine_tool {

/// How what a query refers to is read; paths are as the query writes them.
struct References {
  std::function<Result<world::World, Diagnostics>(const std::string& path)> world_in_file;
  /// Reads the rasters of a world that was written inside the query.
  std::function<Result<world::World, Diagnostics>(world::WorldFile inside)> world_inside;
  std::function<Result<world::VehicleModel, Diagnostics>(const std::string& path)> vehicle_in_file;
  /// The polygons of a file, in the frame of that origin; `crs`: as geodata::read_shapes has it.
  std::function<Result<std::vector<geodata::Shape>, Diagnostics>(
      const std::string& path, const world::GeodeticOrigin& origin, const std::string& crs)>
      shapes_in_file = {};
};

/// Reads a query and, through `references`, what it names. `file` is for messages. Every error at
/// once; those about places and zones only when the world could be read.
Result<Query, Diagnostics> read_query(std::string_view text, const std::string& file,
                                      const References& references);

}  // namespace skein::refine_tool
