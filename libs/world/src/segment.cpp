// SPDX-License-Identifier: Apache-2.0
#include "skein/world/segment.hpp"

#include <limits>

namespace skein::world {

namespace {

/// Positive where `p` is left of the line from `a` to `b`.
double side(const Vector2& a, const Vector2& b, const Vector2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

}  // namespace

double to_polygon(const Vector2& point, const Polygon& polygon) {
  if (contains(polygon, point)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, to_segment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

double between_segments(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
  return std::min(
      {to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
}

}  // namespace skein::world
