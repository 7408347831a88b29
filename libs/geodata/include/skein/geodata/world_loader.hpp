// SPDX-License-Identifier: Apache-2.0
// World files with all they refer to.
#pragma once

#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/world.hpp"
#include "skein/world/world_file.hpp"

namespace skein::geodata {

/// Reads a world file (YAML) and its rasters, whose names are relative to its folder. Every error
/// of the text at once; then those of the rasters.
Result<world::World, Diagnostics> read_world(const std::string& path);

/// The same for a file that was read already: finds its rasters and its places on Earth.
Result<world::World, Diagnostics> load_world(world::WorldFile file, const std::string& folder);

}  // namespace skein::geodata
