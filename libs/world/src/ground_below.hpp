// SPDX-License-Identifier: Apache-2.0
// The ground under columns of voxels.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "skein/world/airspace.hpp"
#include "work_clock.hpp"

namespace skein::world {

/// The elevations of the ground under a column of voxels.
struct Ground {
  double lowest, highest;  // [m]
};

/// A rectangle of voxel columns, from column x and row y on.
struct ColumnTile {
  std::int32_t x = 0, y = 0, columns = 0, rows = 0;

  std::size_t count() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

/// Computes the ground under the columns of a grid, exactly for the bilinear surface of a terrain;
/// tile by tile, to save memory. Grid and terrain must outlive it. Thread rule: one thread.
class GroundBelow {
 public:
  /// The footprint of each column is grown by `margin` [m].
  GroundBelow(const AirspaceGrid& grid, const Terrain& terrain, double margin)
      : grid_(grid), terrain_(terrain), margin_(margin) {}

  /// The ground under the columns of a tile, row by row; incomplete once the clock is up.
  const std::vector<Ground>& of(const ColumnTile& tile, WorkClock& clock);

 private:
  /// The same places along one axis for all rows (or columns) of voxels, each once; and which of
  /// them are of which row: [first, end).
  struct Corners {
    std::vector<double> places;
    std::vector<std::pair<std::size_t, std::size_t>> of_voxels;
  };

  Corners corners_of_columns(std::int32_t first, std::int32_t count) const;
  Corners corners_of_rows(std::int32_t first, std::int32_t count) const;
  void follow_line(double y);

  const AirspaceGrid& grid_;
  const Terrain& terrain_;
  double margin_;
  std::int32_t first_column_ = -1;  // of those that xs_ is about
  Corners xs_;
  std::vector<double> heights_;  // at the places of xs_, along one line from west to east
  std::vector<Ground> line_;     // under each column, along that line
  std::vector<Ground> grounds_;
};

}  // namespace skein::world
