// SPDX-License-Identifier: Apache-2.0
// Ground that no post of its raster stands out of.
#pragma once

#include "raster.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/world/terrain.hpp"

namespace skein::geodata {

class RasterSampler;

/// By how much the corners of a ground were raised [m].
struct Raised {
  double most = 0, mean = 0;
};

/// Raises the corners of the cells as little as is needed (by the least sum of squares for each
/// place) so that the ground, bilinear between them, is nowhere below a post of the raster, nor
/// below the straight line between two posts side by side where that crosses a line of the grid. So
/// where the grid lies along the raster's, it is nowhere below the raster's own bilinear surface.
/// Cost: some 20 ns for each post. Precondition: as many elevations as corners.
Raised raise_above(world::TerrainSpec& terrain, const RasterSampler& sampler, const Raster& raster,
                   const geodesy::GeodeticFrame& frame);

}  // namespace skein::geodata
