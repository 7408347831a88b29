// SPDX-License-Identifier: Apache-2.0
#include "patrol/sight.hpp"

#include <array>

namespace skein::refiners {
namespace {

/// About what it takes to look at one place, and along a line of sight [ns].
constexpr std::uint32_t kElevations = 100, kLook = 5000;

/// The greatest rise of the ground per metre anywhere near the grid. Within a cell of a bilinear
/// surface the slope along each axis lies between those of two edges.
double steepest(const world::Terrain& terrain, const world::Grid& grid, Deadline& deadline) {
  const double step = terrain.spec().cell;
  const double west = grid.west - step, south = grid.south - step;
  const double east = grid.west + static_cast<double>(grid.columns) * grid.cell + step;
  const double north = grid.south + static_cast<double>(grid.rows) * grid.cell + step;
  const world::TerrainSpec& spec = terrain.spec();
  const auto first = [&](double low, double origin) {
    return std::max(0.0, std::floor((low - origin) / step));
  };
  double along_x = 0, along_y = 0;
  for (double j = first(south, spec.south);
       spec.south + j * step <= std::min(north, spec.north + step); ++j)
    for (double i = first(west, spec.west);
         spec.west + i * step <= std::min(east, spec.east + step); ++i) {
      if (deadline.passed_after(kElevations)) return 0;
      const double x = spec.west + i * step, y = spec.south + j * step;
      const double here = terrain.elevation(x, y);
      along_x = std::max(along_x, std::abs(terrain.elevation(x + step, y) - here) / step);
      along_y = std::max(along_y, std::abs(terrain.elevation(x, y + step) - here) / step);
    }
  return std::hypot(along_x, along_y);
}

/// What is perceived from exactly the edge of the footprint stays so whatever the rounding.
constexpr double kHair = 1 + 1e-9;

}  // namespace

// From a cell at distance y, the ray to the vehicle has risen at least (h / d - g) y, the ground at
// most g y: with h >= 2 g d the ground stays below.
PatrolSight::PatrolSight(const world::Terrain& terrain, const world::Grid& grid, double altitude,
                         double footprint, Deadline& deadline)
    : terrain_(terrain),
      grid_(grid),
      altitude_(altitude),
      footprint_(footprint * kHair),
      deadline_(deadline),
      rough_(altitude < 2 * footprint * steepest(terrain, grid, deadline)) {}

bool PatrolSight::is_unhidden(const world::Vector2& from, std::size_t cell) const {
  if (!rough_) return true;
  const auto over = grid_.at(from);
  const world::Vector2 at = over ? grid_.centre(*over) : from;
  const world::Vector2 centre = grid_.centre(cell);
  const auto look = [&] {
    const world::Vector3 eye(at.x(), at.y(), terrain_.elevation(at.x(), at.y()) + altitude_);
    const world::Vector3 ground(centre.x(), centre.y(), terrain_.elevation(centre.x(), centre.y()));
    return terrain_.line_of_sight(eye, ground);
  };
  if (!over) return deadline_.passed_after(kLook) || look();
  const std::uint64_t key = static_cast<std::uint64_t>(*over) * grid_.size() + cell;
  const auto known = remembered_.find(key);
  if (known != remembered_.end()) return known->second;
  if (deadline_.passed_after(kLook)) return true;
  return remembered_[key] = look();
}

}  // namespace skein::refiners
