// SPDX-License-Identifier: Apache-2.0
// The ground of the map: shaded relief as an image, contour lines as a path.
#pragma once

#include <utility>
#include <vector>

#include "plot.hpp"
#include "skein/drawing/pixels.hpp"
#include "skein/report/run_info.hpp"

namespace skein::report {

/// Whether the grid has a value for each of its cells and is at least 2 × 2.
bool is_usable(const TerrainGrid& grid);

/// Relief of `view`, lit from the north-west: the hue by height, the shade by slope (exaggerated
/// until the steepest slope shows). Outside the grid the value at its edge is used.
/// Preconditions: the grid is usable; the view has an area. Source: Horn 1981 (hill shading).
drawing::Pixels shaded_relief(const TerrainGrid& grid, const Extents& view, std::size_t width,
                              std::size_t height);

struct Contour {
  double height = 0.0;                                        ///< [m]
  std::vector<std::pair<GroundPoint, GroundPoint>> segments;  ///< not joined
};

/// Marching squares over the grid (thinned to 200 cells a side), about eight round heights; empty
/// on flat ground. Precondition: the grid is usable.
std::vector<Contour> contours(const TerrainGrid& grid);

}  // namespace skein::report
