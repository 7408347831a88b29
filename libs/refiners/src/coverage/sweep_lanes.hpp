// SPDX-License-Identifier: Apache-2.0
// The lanes that sweep a region along one direction.
#pragma once

#include <cstddef>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::refiners {

/// The area to sweep: `outer` without the holes.
struct Region {
  world::Polygon outer;
  std::vector<world::Polygon> holes;
};

/// The sweep frame: x along the lanes, y across them (the plane turned by -direction).
class SweepFrame {
 public:
  explicit SweepFrame(double direction);
  world::Vector2 in(const world::Vector2& point) const;
  world::Vector2 out(const world::Vector2& point) const;
  /// Cost: O(corners).
  void turn(const world::Polygon& polygon, world::Polygon& into) const;
  Region in(const Region& region) const;

 private:
  double cos_, sin_;
};

/// One lane in the sweep frame.
struct Strip {
  double y = 0;
  double from = 0, to = 0;  ///< along x; from <= to
};

/// Lanes that lie side by side, in the order of y: each overlaps the next along x.
using Block = std::vector<Strip>;

/// Extent of the region across the lanes.
struct Breadth {
  double low = 0, high = 0;
  double width() const { return high - low; }
};
Breadth breadth_of(const world::Polygon& turned);

/// max(1, ceil(width / swath)), ignoring an excess over a whole number of swaths that is only due
/// to rounding.
std::size_t lane_count(double width, double swath);

/// One lane per strip of equal height; each spans the extent of the polygon in its strip, so that
/// its swath covers all of the polygon there. Cost: O(corners + lanes).
void whole_strips(const world::Polygon& turned, double swath, Block& lanes);

/// The same strips, with lanes cut where more than `gap` metres need no sweeping, grouped in
/// blocks. Cost: O(corners × (log corners + edges across) + lanes).
std::vector<Block> split_strips(const Region& turned, double swath, double gap);

}  // namespace skein::refiners
