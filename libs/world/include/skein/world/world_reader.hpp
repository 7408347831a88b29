// SPDX-License-Identifier: Apache-2.0
// World files (YAML).
#pragma once

#include <string>
#include <string_view>

#include "skein/config/reader.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/world_file.hpp"

namespace skein::world {

/// Reads what a world file says, no other file. `file` is only the name used in diagnostics.
/// Unknown, repeated and missing keys, wrong types, figures out of range, polygons that cross
/// themselves are errors; all of them are returned at once. The format is in the README;
/// scenarios/terrain has examples. geodata's read_world() reads the rasters too.
Result<WorldFile, Diagnostics> read_world_file(std::string_view text, const std::string& file);

/// The same of a world inside another document. What is wrong goes to the reader's diagnostics, and
/// something harmless is given in its place.
WorldFile read_world_file(const config::Reader& reader);

}  // namespace skein::world
