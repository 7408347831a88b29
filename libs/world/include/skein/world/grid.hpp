// SPDX-License-Identifier: Apache-2.0
// Square cells over a rectangle of the ground.
#pragma once

#include <cstddef>
#include <optional>

#include "skein/world/geometry.hpp"

namespace skein::world {

/// The shape of a raster in the local frame; cell (0, 0) is the south-west one.
struct Grid {
  double west = 0, south = 0;  ///< corner [m], ENU
  double cell = 1;             ///< side [m], > 0
  std::size_t columns = 0, rows = 0;
  bool operator==(const Grid&) const = default;

  std::size_t size() const { return columns * rows; }
  /// Row-major, rows from south to north. Precondition: inside.
  std::size_t index(std::size_t column, std::size_t row) const { return row * columns + column; }
  Vector2 centre(std::size_t index) const {
    return {west + (static_cast<double>(index % columns) + 0.5) * cell,
            south + (static_cast<double>(index / columns) + 0.5) * cell};
  }
  /// The cell a point is in; nothing outside.
  std::optional<std::size_t> at(const Vector2& point) const {
    const double u = (point.x() - west) / cell, v = (point.y() - south) / cell;
    if (!(u >= 0 && v >= 0 && u < static_cast<double>(columns) && v < static_cast<double>(rows)))
      return std::nullopt;
    return index(static_cast<std::size_t>(u), static_cast<std::size_t>(v));
  }
};

}  // namespace skein::world
