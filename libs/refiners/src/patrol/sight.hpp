// SPDX-License-Identifier: Apache-2.0
// Visibility of the ground cells from the vehicle's positions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "common/deadline.hpp"
#include "skein/world/grid.hpp"
#include "skein/world/terrain.hpp"

namespace skein::refiners {

/// A cell is perceived while the vehicle is at most `footprint` from above its centre
/// (horizontally) and the ground does not hide it. Line of sight is tested from above the centre of
/// the cell below the vehicle, and cached. No test is made if the ground is too even to hide
/// anything from that altitude. Once the time is up no test is made either, and every cell counts
/// as perceived: results must then be discarded. Thread rule: one thread (it caches).
class PatrolSight {
 public:
  /// `deadline` must outlive this object.
  PatrolSight(const world::Terrain& terrain, const world::Grid& grid, double altitude,
              double footprint, Deadline& deadline);

  const world::Grid& grid() const { return grid_; }
  double footprint() const { return footprint_; }
  double altitude() const { return altitude_; }
  bool is_ever_hidden() const { return rough_; }
  Deadline& deadline() const { return deadline_; }
  /// Whether the ground does not hide the centre of a cell from `from`, whatever their distance.
  bool is_unhidden(const world::Vector2& from, std::size_t cell) const;
  bool sees(const world::Vector2& from, std::size_t cell) const {
    return (grid_.centre(cell) - from).norm() <= footprint_ && is_unhidden(from, cell);
  }

  /// Calls visit(cell, enter, leave) for each cell of the grid that comes within `reach` of the
  /// straight segment; enter <= leave are fractions of it, in [0, 1]. Ignores the terrain.
  template <class Visit>
  void for_each_near(const world::Vector2& from, const world::Vector2& to, double reach,
                     Visit&& visit) const;

 private:
  struct Span {
    double low, high;
  };
  /// Fractions of the segment within `reach` of a point; low > high when there are none.
  static Span within(const world::Vector2& from, const world::Vector2& step, double length2,
                     const world::Vector2& point, double reach);

  const world::Terrain& terrain_;
  world::Grid grid_;
  double altitude_, footprint_;
  Deadline& deadline_;
  bool rough_;
  mutable std::unordered_map<std::uint64_t, bool> remembered_;  // never iterated
};

inline PatrolSight::Span PatrolSight::within(const world::Vector2& from, const world::Vector2& step,
                                             double length2, const world::Vector2& point,
                                             double reach) {
  const world::Vector2 offset = point - from;
  if (length2 <= 0) return offset.norm() <= reach ? Span{0, 1} : Span{1, 0};
  const double middle = offset.dot(step) / length2;
  const double across2 = offset.squaredNorm() - middle * middle * length2;
  const double left = reach * reach - across2;
  if (left < 0) return {1, 0};
  const double half = std::sqrt(left / length2);
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

template <class Visit>
void PatrolSight::for_each_near(const world::Vector2& from, const world::Vector2& to, double reach,
                                Visit&& visit) const {
  const world::Vector2 step = to - from;
  const double length2 = step.squaredNorm();
  const auto cell_range = [&](double low, double high, double origin, std::size_t count) {
    const double limit = static_cast<double>(count);
    const double first = std::clamp(std::ceil((low - origin) / grid_.cell - 0.5), 0.0, limit);
    const double end = std::clamp(std::floor((high - origin) / grid_.cell - 0.5) + 1, 0.0, limit);
    return std::pair{static_cast<std::size_t>(first),
                     static_cast<std::size_t>(std::max(first, end))};
  };
  const auto [south, north] =
      cell_range(std::min(from.y(), to.y()) - reach, std::max(from.y(), to.y()) + reach,
                 grid_.south, grid_.rows);
  for (std::size_t row = south; row < north; ++row) {
    const double y = grid_.south + (static_cast<double>(row) + 0.5) * grid_.cell;
    double a = 0, b = 1;  // the part of the segment from which this row is in reach
    if (step.y() != 0) {
      const double one = (y - reach - from.y()) / step.y(),
                   other = (y + reach - from.y()) / step.y();
      a = std::max(0.0, std::min(one, other));
      b = std::min(1.0, std::max(one, other));
    }
    const double xa = from.x() + a * step.x(), xb = from.x() + b * step.x();
    const auto [west, east] =
        cell_range(std::min(xa, xb) - reach, std::max(xa, xb) + reach, grid_.west, grid_.columns);
    for (std::size_t column = west; column < east; ++column) {
      const std::size_t cell = grid_.index(column, row);
      const Span span = within(from, step, length2, grid_.centre(cell), reach);
      if (span.low <= span.high) visit(cell, span.low, span.high);
    }
  }
}

}  // namespace skein::refiners
