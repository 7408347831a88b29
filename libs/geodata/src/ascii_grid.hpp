// SPDX-License-Identifier: Apache-2.0
// What GDAL does not say of an ESRI ASCII grid: it takes every word for a number.
#pragma once

#include <optional>
#include <string>

#include "raster.hpp"

namespace skein::geodata {

/// The first value that is no number, or values that are too few or too many; nothing when all are
/// right. The file begins with lines of a key and a figure, as `ncols 403`. Cost: the file is read
/// once, some 10 ms a megabyte.
std::optional<RasterProblem> problem_in_ascii_grid(const std::string& path);

}  // namespace skein::geodata
