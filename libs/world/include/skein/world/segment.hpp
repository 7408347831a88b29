// SPDX-License-Identifier: Apache-2.0
// How far a point is from a straight piece of a way or of a border, in the plane or in space.
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

}  // namespace skein::world
