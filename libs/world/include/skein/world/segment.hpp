// SPDX-License-Identifier: Apache-2.0
// How far a point is from a straight piece of a way or of a border, or from a polygon; and how far
// two pieces are apart.
#pragma once

#include <algorithm>

#include "skein/world/geometry.hpp"

namespace skein::world {

/// From the point to the nearest of the segment [m]; `a` may be `b`. Vector: Vector2 or Vector3.
template <class Vector>
double to_segment(const Vector& point, const Vector& a, const Vector& b) {
  const Vector along = b - a;
  const double length = along.squaredNorm();
  const double at = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - (a + at * along)).norm();
}

/// From the point to the nearest of the polygon [m]; 0 inside it.
double to_polygon(const Vector2& point, const Polygon& polygon);

/// Between the nearest points of two segments in the plane [m]; 0 where they cross. Either may be
/// a point.
double between_segments(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d);

}  // namespace skein::world
