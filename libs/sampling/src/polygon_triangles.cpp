// SPDX-License-Identifier: Apache-2.0
#include "polygon_triangles.hpp"

#include <algorithm>
#include <cstddef>

namespace skein::sampling {
namespace {

using world::Vector2;
using Triangle = std::array<Vector2, 3>;

/// Twice the signed area.
double turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool holds(const Triangle& triangle, const Vector2& point) {
  return turn(triangle[0], triangle[1], point) >= 0 && turn(triangle[1], triangle[2], point) >= 0 &&
         turn(triangle[2], triangle[0], point) >= 0;
}

/// The corner cut off is convex, and no other corner of the polygon is in what is cut off.
bool is_ear(const Triangle& triangle, const std::vector<Vector2>& rest) {
  if (turn(triangle[0], triangle[1], triangle[2]) <= 0) return false;
  return std::none_of(rest.begin(), rest.end(), [&](const Vector2& point) {
    const bool own = point == triangle[0] || point == triangle[1] || point == triangle[2];
    return !own && holds(triangle, point);
  });
}

double signed_area(const std::vector<Vector2>& corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += turn(corners.front(), corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

}  // namespace

std::vector<Triangle> triangles_of(const world::Polygon& polygon) {
  std::vector<Vector2> rest = polygon;
  if (signed_area(rest) < 0) std::reverse(rest.begin(), rest.end());
  std::vector<Triangle> triangles;
  const auto corner = [&](std::size_t i) -> const Vector2& { return rest[i % rest.size()]; };
  while (rest.size() >= 3) {
    std::size_t ear = rest.size(), flat = rest.size();
    for (std::size_t i = 0; i < rest.size() && ear == rest.size(); ++i) {
      const Triangle cut = {corner(i), corner(i + 1), corner(i + 2)};
      if (is_ear(cut, rest)) ear = i;
      if (turn(cut[0], cut[1], cut[2]) == 0 && flat == rest.size()) flat = i;
    }
    // Without an ear only corners in line are left (of a simple polygon): they hold no area.
    const std::size_t gone = ear < rest.size() ? ear : (flat < rest.size() ? flat : 0);
    if (ear < rest.size()) triangles.push_back({corner(gone), corner(gone + 1), corner(gone + 2)});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>((gone + 1) % rest.size()));
  }
  return triangles;
}

}  // namespace skein::sampling
