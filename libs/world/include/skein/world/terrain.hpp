// SPDX-License-Identifier: Apache-2.0
// The ground: a regular grid of elevations, and what can be seen over it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::world {

/// A smooth round hill: height × (1 + cos(π d / radius)) / 2 at distance d < radius from its top.
struct HillSpec {
  Vector2 at = Vector2::Zero();
  double height = 0;  ///< [m]; negative makes a hollow
  double radius = 0;  ///< > 0 [m]
};

/// What a terrain is made from. The hills add up on the base.
struct TerrainSpec {
  double west = 0, south = 0, east = 0, north = 0;  ///< extent [m], local ENU
  double cell = 20;                                 ///< side of a grid cell [m]
  double base = 0;                                  ///< elevation without hills [m], ENU z
  std::vector<HillSpec> hills;
  /// Measured ground, for what a raster gave: elevations at the corners of the cells [m, ENU z],
  /// row-major from the south-west, (columns + 1) × (rows + 1) of them, where columns is
  /// ceil((east - west) / cell). Empty: level ground at `base`. The hills add up on it either way.
  std::vector<double> elevations;
};

/// Most cells a terrain may have, so that a wrong figure in a file cannot exhaust memory.
inline constexpr double kMaxTerrainCells = 4e6;

/// Most hills, so that a file cannot ask for endless work.
inline constexpr std::size_t kMostHills = 1000;

/// How many corners of cells a terrain has.
struct TerrainCorners {
  std::size_t columns = 0, rows = 0;  ///< along east and north; each >= 2
  std::size_t count() const { return columns * rows; }
};
/// Precondition: the extent and the cell are such that problems_of() does not speak of them.
TerrainCorners corners_of(const TerrainSpec& spec);

/// Why no terrain can be made from it, in sentences, all at once; empty when one can.
std::vector<std::string> problems_of(const TerrainSpec& spec);

/// Elevations at the corners of square cells, bilinear between. A value type; reading is const and
/// safe from any thread. Outside its extent the ground goes on as it is at the nearest border
/// point, and hides nothing. Source: spec 4.1.
class Terrain {
 public:
  /// Precondition: problems_of(spec) is empty. Moved in, its elevations are not copied.
  explicit Terrain(TerrainSpec spec);

  /// True inside and on the border of the extent given.
  bool contains(double x, double y) const;
  /// ENU z of the ground [m]. O(1).
  double elevation(double x, double y) const;
  /// Steepness of the ground [rad], from 0 (level) up to π/2. O(1).
  double slope(double x, double y) const;
  /// The highest elevation of the grid [m].
  double highest() const { return highest_; }
  /// The lowest elevation of the grid [m].
  double lowest() const { return lowest_; }

  /// True when the straight segment stays at least `clearance` [m] above the ground (negative: may
  /// graze below it by as much). Exact for the bilinear surface, so symmetrical in a and b.
  /// Cost: O(cells crossed); none when both ends are above the highest point.
  bool line_of_sight(const Vector3& a, const Vector3& b, double clearance = 0) const;
  /// The first fraction of the way from a to b, in [0, 1], where it comes closer than `clearance`
  /// to the ground; nothing when it never does. 0 when a coordinate is NaN or infinite: there is
  /// nothing that can be seen from there.
  std::optional<double> first_hit(const Vector3& a, const Vector3& b, double clearance = 0) const;

  /// What it was made from, without the measured elevations: these are the corners now.
  const TerrainSpec& spec() const { return spec_; }
  /// The elevation of a corner of the grid [m]. Precondition: inside corners_of(spec()).
  double corner(std::size_t column, std::size_t row) const { return node(column, row); }

 private:
  void add(const HillSpec& hill);
  struct Cell {
    std::size_t column, row;
  };
  double node(std::size_t column, std::size_t row) const { return nodes_[row * columns_ + column]; }
  Cell cell_at(double u, double v) const;
  std::optional<double> hit_in_cell(const Vector3& a, const Vector3& step, double from,
                                    double until, double clearance) const;

  TerrainSpec spec_;
  std::size_t columns_ = 0, rows_ = 0;  ///< of corners: one more than of cells
  std::vector<double> nodes_;           ///< row-major, rows from south to north
  double lowest_ = 0, highest_ = 0;
};

}  // namespace skein::world
