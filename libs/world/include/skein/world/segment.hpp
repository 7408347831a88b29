// SPDX-License-Identifier: Apache-2.0
// Distances between points, straight segments and polygons.
#pragma once

#include <algorithm>

#include "skein/world/geometry.hpp"

namespace skein::world {

/// The point of a segment that is nearest to `point`; `a` may be `b`. Vector: Vector2 or Vector3.
template <class Vector>
Vector nearest_on_segment(const Vector& point, const Vector& a, const Vector& b) {
  const Vector along = b - a;
  const double length = along.squaredNorm();
  const double at = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return a + at * along;
}

/// Distance from a point to a segment [m]; likewise.
template <class Vector>
double to_segment(const Vector& point, const Vector& a, const Vector& b) {
  return (point - nearest_on_segment(point, a, b)).norm();
}

/// Distance from a point to a polygon [m]; 0 inside it.
double to_polygon(const Vector2& point, const Polygon& polygon);

/// Distance between two segments in the plane [m]; 0 if they cross. Either may be a point.
double between_segments(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d);

}  // namespace skein::world
