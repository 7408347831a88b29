// SPDX-License-Identifier: Apache-2.0
// Where a vehicle on patrol may be: inside the zone, out of the volumes closed at its altitude.
#pragma once

#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::refiners {

/// Plane figures; the border of the zone is open, that of what is closed is closed. Immutable.
class PatrolSpace {
 public:
  PatrolSpace(world::Polygon zone, std::vector<world::Polygon> closed);

  bool is_open(const world::Vector2& at) const;
  /// The whole straight segment. Cost: O(corners).
  bool is_open(const world::Vector2& from, const world::Vector2& to) const;
  /// Out of what is closed, wherever the zone is.
  bool is_clear(const world::Vector2& at) const;
  bool is_clear(const world::Vector2& from, const world::Vector2& to) const;
  /// How far outside the zone a point is [m]; 0 inside.
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
