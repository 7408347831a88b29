// SPDX-License-Identifier: Apache-2.0
// Free space of a patrol: inside the zone, outside of the volumes closed at its altitude.
#pragma once

#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::refiners {

/// Plane polygons. The border of the zone counts as free, that of closed volumes as closed.
/// Immutable.
class PatrolSpace {
 public:
  PatrolSpace(world::Polygon zone, std::vector<world::Polygon> closed);

  bool is_open(const world::Vector2& at) const;
  /// Whether the whole straight segment is free. Cost: O(corners).
  bool is_open(const world::Vector2& from, const world::Vector2& to) const;
  /// Whether a point (segment) is outside of all closed volumes, regardless of the zone.
  bool is_clear(const world::Vector2& at) const;
  bool is_clear(const world::Vector2& from, const world::Vector2& to) const;
  /// Distance of a point from the zone [m]; 0 inside.
  double outside(const world::Vector2& at) const;
  /// True when any segment between two open points is open.
  bool is_simple() const { return convex_ && closed_.empty(); }
  bool is_convex() const { return convex_; }
  const std::vector<world::Polygon>& closed() const { return closed_; }

 private:
  bool stays_in_zone(const world::Vector2& from, const world::Vector2& to) const;

  world::Polygon zone_;
  std::vector<world::Polygon> closed_;
  bool convex_;
};

}  // namespace skein::refiners
