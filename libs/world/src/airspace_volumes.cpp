// SPDX-License-Identifier: Apache-2.0
// Which voxels a volume touches.
#include <algorithm>
#include <cmath>

#include "skein/foundation/contract.hpp"
#include "skein/world/airspace.hpp"
#include "work_clock.hpp"

namespace skein::world {
namespace {

/// Touching within as much [m] is touching.
constexpr double kTouch = 1e-9;

struct Rectangle {
  Vector2 low, high;
};

double distance(const Rectangle& rectangle, const Vector2& point) {
  return (point - point.cwiseMax(rectangle.low).cwiseMin(rectangle.high)).norm();
}

double distance(const Vector2& a, const Vector2& b, const Vector2& point) {
  const Vector2 edge = b - a;
  const double length2 = edge.squaredNorm();
  const double along = length2 > 0 ? std::clamp(edge.dot(point - a) / length2, 0.0, 1.0) : 0;
  return (a + along * edge - point).norm();
}

/// True when some part of the segment is in the rectangle.
bool crosses(const Rectangle& rectangle, const Vector2& a, const Vector2& b) {
  double from = 0, until = 1;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double step = b[i] - a[i];
    if (step == 0) {
      if (a[i] < rectangle.low[i] || a[i] > rectangle.high[i]) return false;
      continue;
    }
    const double s = (rectangle.low[i] - a[i]) / step, t = (rectangle.high[i] - a[i]) / step;
    from = std::max(from, std::min(s, t));
    until = std::min(until, std::max(s, t));
  }
  return from <= until;
}

bool within(const Rectangle& rectangle, const Vector2& a, const Vector2& b, double margin) {
  if (distance(rectangle, a) <= margin || distance(rectangle, b) <= margin ||
      crosses(rectangle, a, b))
    return true;
  const Vector2 south_east(rectangle.high.x(), rectangle.low.y());
  const Vector2 north_west(rectangle.low.x(), rectangle.high.y());
  return distance(a, b, rectangle.low) <= margin || distance(a, b, rectangle.high) <= margin ||
         distance(a, b, south_east) <= margin || distance(a, b, north_west) <= margin;
}

/// The voxels along one axis whose closed extents meet [from, until], as [first, last].
struct Range {
  std::int32_t first = 0, last = -1;
};
Range touched(double from, double until, double origin, double voxel, std::int32_t size) {
  const double low = std::ceil((from - kTouch - origin) / voxel - 1);
  const double high = std::floor((until + kTouch - origin) / voxel);
  if (!(low <= size - 1) || !(high >= 0)) return {};
  return {static_cast<std::int32_t>(std::max(low, 0.0)),
          static_cast<std::int32_t>(std::min(high, size - 1.0))};
}

/// Calls `touch(first, last, y)` for every row of columns of voxels that a polygon grown by a
/// margin touches, some more than once, until it says false.
template <class Touch>
class Footprint {
 public:
  Footprint(const AirspaceGrid& grid, const Polygon& polygon, double margin, const Touch& touch)
      : grid_(grid), polygon_(polygon), margin_(margin + kTouch), touch_(touch) {}

  /// True when it never said false.
  bool trace() const {
    for (std::size_t i = 0; i < polygon_.size(); ++i)
      if (!trace_edge(polygon_[i], polygon_[(i + 1) % polygon_.size()])) return false;
    double low = polygon_[0].y(), high = low;
    for (const Vector2& corner : polygon_) {
      low = std::min(low, corner.y());
      high = std::max(high, corner.y());
    }
    const Range rows = touched(low, high, grid_.origin.y(), grid_.voxel, grid_.size[1]);
    for (std::int32_t y = rows.first; y <= rows.last; ++y)
      if (!fill_row(y)) return false;
    return true;
  }

 private:
  Rectangle footprint(std::int32_t x, std::int32_t y) const {
    const Vector2 low(grid_.origin.x() + x * grid_.voxel, grid_.origin.y() + y * grid_.voxel);
    return {low, low + Vector2(grid_.voxel, grid_.voxel)};
  }

  /// Every column that the edge, grown, touches.
  bool trace_edge(const Vector2& a, const Vector2& b) const {
    const Range rows = touched(std::min(a.y(), b.y()) - margin_, std::max(a.y(), b.y()) + margin_,
                               grid_.origin.y(), grid_.voxel, grid_.size[1]);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) {
      const Range columns = columns_of(a, b, y);
      for (std::int32_t x = columns.first; x <= columns.last; ++x)
        if (within(footprint(x, y), a, b, margin_) && !touch_(x, x, y)) return false;
    }
    return true;
  }

  /// The columns of a row that the edge can come near.
  Range columns_of(const Vector2& a, const Vector2& b, std::int32_t y) const {
    double from = 0, until = 1;
    if (a.y() != b.y()) {
      const Rectangle row = footprint(0, y);
      const double s = (row.low.y() - margin_ - a.y()) / (b.y() - a.y());
      const double t = (row.high.y() + margin_ - a.y()) / (b.y() - a.y());
      from = std::clamp(std::min(s, t), 0.0, 1.0);
      until = std::clamp(std::max(s, t), 0.0, 1.0);
    }
    const double p = a.x() + from * (b.x() - a.x()), q = a.x() + until * (b.x() - a.x());
    return touched(std::min(p, q) - margin_, std::max(p, q) + margin_, grid_.origin.x(),
                   grid_.voxel, grid_.size[0]);
  }

  /// The columns whose centre is inside; those that only the border touches are traced.
  bool fill_row(std::int32_t y) const {
    const double level = grid_.origin.y() + (y + 0.5) * grid_.voxel;
    std::vector<double> crossings;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Vector2& a = polygon_[i];
      const Vector2& b = polygon_[(i + 1) % polygon_.size()];
      if ((a.y() > level) == (b.y() > level)) continue;
      crossings.push_back(a.x() + (b.x() - a.x()) * (level - a.y()) / (b.y() - a.y()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double half = grid_.voxel / 2;
      const double low = std::ceil((crossings[i] - grid_.origin.x() - half) / grid_.voxel);
      const double high = std::floor((crossings[i + 1] - grid_.origin.x() - half) / grid_.voxel);
      const double first = std::max(low, 0.0), last = std::min(high, grid_.size[0] - 1.0);
      if (first <= last &&
          !touch_(static_cast<std::int32_t>(first), static_cast<std::int32_t>(last), y))
        return false;
    }
    return true;
  }

  const AirspaceGrid& grid_;
  const Polygon& polygon_;
  double margin_;
  const Touch& touch_;
};

/// Calls `touch(index, count)` for all voxels that a volume grown by a margin touches, as many as
/// lie in a row at once. False once the clock is up.
template <class Touch>
bool for_each_touched(const AirspaceGrid& grid, const Volume& volume, double margin,
                      WorkClock& clock, const Touch& touch) {
  constexpr std::size_t kRow = 50, kAlong = 8;  // what a row takes [ns], and of it in one more
  SKEIN_EXPECTS(margin >= 0);
  for (const Vector2& corner : volume.polygon) SKEIN_EXPECTS(corner.allFinite());
  const Range levels = touched(volume.floor - margin, volume.ceiling + margin, grid.origin.z(),
                               grid.voxel, grid.size[2]);
  if (volume.polygon.empty() || levels.last < levels.first) return true;
  const auto rows = [&](std::int32_t first, std::int32_t last, std::int32_t y) {
    const auto count = static_cast<std::size_t>(last - first + 1);
    if (clock.is_up_after(10 * volume.polygon.size())) return false;
    for (std::int32_t z = levels.first; z <= levels.last; ++z) {
      touch(grid.index(first, y, z), count);
      if (clock.is_up_after(kRow + count / kAlong)) return false;
    }
    return true;
  };
  return Footprint(grid, volume.polygon, margin, rows).trace();
}

}  // namespace

bool Airspace::block(const Volume& volume, double margin, const std::function<bool()>& time_is_up) {
  WorkClock clock(time_is_up);
  return for_each_touched(grid_, volume, margin, clock, [&](std::size_t first, std::size_t count) {
    std::fill_n(&voxels_[first], count, kBlocked);
  });
}

bool Airspace::keep_where(const std::function<bool(const Voxel&)>& keep,
                          const std::function<bool()>& time_is_up) {
  constexpr std::size_t kAsked = 40, kPassed = 1;  // what a call takes, and what is blocked [ns]
  WorkClock clock(time_is_up);
  std::size_t index = 0;
  Voxel at{};
  for (at[2] = 0; at[2] < grid_.size[2]; ++at[2])
    for (at[1] = 0; at[1] < grid_.size[1]; ++at[1])
      for (at[0] = 0; at[0] < grid_.size[0]; ++at[0], ++index) {
        const bool is_asked = voxels_[index] != kBlocked;
        if (is_asked && !keep(at)) voxels_[index] = kBlocked;
        if (clock.is_up_after(is_asked ? kAsked : kPassed)) return false;
      }
  return true;
}

void Airspace::set_cost(const Volume& volume, double crossing_cost) {
  SKEIN_EXPECTS(!std::isnan(crossing_cost));
  const double steps = std::round(std::clamp(crossing_cost / kCostStep, 16.0, 255.0));
  const auto cost = static_cast<std::uint8_t>(steps);
  least_cost_ = std::min(least_cost_, cost);
  greatest_cost_ = std::max(greatest_cost_, cost);
  const std::function<bool()> never;
  WorkClock clock(never);
  for_each_touched(grid_, volume, 0, clock, [&](std::size_t first, std::size_t count) {
    for (std::size_t index = first; index < first + count; ++index)
      if (voxels_[index] != kBlocked) voxels_[index] = cost;
  });
}

}  // namespace skein::world
