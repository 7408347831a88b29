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
};

/// Most cells a terrain may have, so that a wrong figure in a file cannot exhaust memory.
inline constexpr double kMaxTerrainCells = 4e6;

/// Why no terrain can be made from it, in sentences, all at once; empty when one can.
std::vector<std::string> problems_of(const TerrainSpec& spec);

/// Elevations at the corners of square cells, bilinear between. A value type; reading is const and
/// safe from any thread. Outside its extent the ground goes on as it is at the nearest border
/// point, and hides nothing. Source: spec 4.1.
class Terrain {
 public:
  /// Precondition: problems_of(spec) is empty.
  explicit Terrain(const TerrainSpec& spec);

  /// True inside and on the border of the extent given.
  bool contains(double x, double y) const;
  /// ENU z of the ground [m]. O(1).
  double elevation(double x, double y) const;
  /// Steepness of the ground [rad], from 0 (level) up to π/2. O(1).
  double slope(double x, double y) const;
  /// The highest elevation of the grid [m].
  double highest() const { return highest_; }

  /// True when the straight segment stays at least `clearance` [m] above the ground (negative: may
  /// graze below it by as much). Exact for the bilinear surface, so symmetrical in a and b.
  /// Cost: O(cells crossed); none when both ends are above the highest point.
  bool line_of_sight(const Vector3& a, const Vector3& b, double clearance = 0) const;
  /// The first fraction of the way from a to b, in [0, 1], where it comes closer than `clearance`
  /// to the ground; nothing when it never does.
  std::optional<double> first_hit(const Vector3& a, const Vector3& b, double clearance = 0) const;

  const TerrainSpec& spec() const { return spec_; }

 private:
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
  double highest_ = 0;
};

}  // namespace skein::world
