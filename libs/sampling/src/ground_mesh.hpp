// SPDX-License-Identifier: Apache-2.0
// A triangle mesh of the ground that is never below the true surface.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "skein/world/terrain.hpp"

namespace skein::sampling {

/// The part of the ground that a mesh covers.
struct Region {
  double west, south, east, north;
};

/// A bilinear patch is not plane: cut along the diagonal along which it is convex, its two
/// triangles lie above it, by at most a quarter of its twist (the height of one diagonal's middle
/// over the other's, doubled). Each cell is cut in as many patches as bring that under the
/// accuracy. Cells meet without cracks, since a patch is straight along its edges. A value type.
class GroundMesh {
 public:
  /// Triangles next to each other, in the order of all; each has its own vertices.
  struct Tile {
    std::size_t first, end;  ///< triangles
    std::size_t first_vertex, end_vertex;
  };

  /// Outside the terrain's extent the ground is extrapolated as in Terrain. `is_late` (may be
  /// empty) is polled; after it has returned true the mesh is incomplete and must not be used.
  GroundMesh(const world::Terrain& terrain, const Region& region, double accuracy,
             std::size_t most_triangles, const std::function<bool()>& is_late = {});

  bool is_whole() const { return whole_; }
  const std::vector<world::Vector3>& vertices() const { return vertices_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  const std::vector<Tile>& tiles() const { return tiles_; }
  double highest() const { return highest_; }
  /// Height of the mesh [m]; outside the region that of its border. Cost: O(log lines).
  double height(double x, double y) const;

 private:
  struct Cell {
    std::array<double, 4> corners{};  ///< heights in the SW, SE, NW, NE
    std::uint32_t cuts = 1;           ///< along each side

    double twist() const { return corners[0] + corners[3] - corners[1] - corners[2]; }
    double at(double u, double v) const;
  };

  void set_lines(const world::Terrain& terrain, const Region& region, std::size_t merged);
  void set_cells(const world::Terrain& terrain, bool merged, const std::function<bool()>& is_late);
  /// Cuts the cells for that accuracy; returns the number of triangles.
  std::size_t cut(double accuracy);
  void emit(const std::function<bool()>& is_late);
  void emit_tile(std::size_t column, std::size_t row);
  void end_tile();
  void emit_patch(const Cell& cell, std::size_t column, std::size_t row, std::uint32_t i,
                  std::uint32_t j);
  const Cell& cell(std::size_t column, std::size_t row) const {
    return cells_[row * (xs_.size() - 1) + column];
  }

  std::vector<double> xs_, ys_;
  std::vector<Cell> cells_;
  std::vector<world::Vector3> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Tile> tiles_;
  double highest_ = 0;
  bool whole_ = true;
};

}  // namespace skein::sampling
