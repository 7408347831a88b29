// SPDX-License-Identifier: Apache-2.0
#include "flight/closed_air.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "skein/world/segment.hpp"

namespace skein::supervisor {
namespace {

using world::Polygon;
using world::Vector2;

constexpr int kSides = 12;  ///< of what stands for a circle, around it

double cross(const Vector2& origin, const Vector2& a, const Vector2& b) {
  return (a.x() - origin.x()) * (b.y() - origin.y()) - (a.y() - origin.y()) * (b.x() - origin.x());
}

/// Counter-clockwise. Source: Andrew's monotone chain.
Polygon hull(Polygon points) {
  std::sort(points.begin(), points.end(), [](const Vector2& a, const Vector2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Polygon all;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = all.size();
    for (const Vector2& point : points) {
      while (all.size() >= first + 2 && cross(all[all.size() - 2], all.back(), point) <= 0)
        all.pop_back();
      all.push_back(point);
    }
    all.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return all;
}

}  // namespace

bool is_near(const world::Volume& volume, const world::Vector3& at, double margin) {
  if (at.z() <= volume.floor - margin || at.z() >= volume.ceiling + margin) return false;
  const double off = world::to_polygon(at.head<2>(), volume.polygon);
  return off < margin || off == 0;
}

world::Volume grown(const world::Volume& volume, double margin) {
  world::Volume all = volume;
  const double reach = margin / std::cos(std::numbers::pi / kSides);
  Polygon corners;
  for (const Vector2& corner : volume.polygon)
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      corners.emplace_back(corner + reach * Vector2(std::cos(angle), std::sin(angle)));
    }
  all.polygon = hull(std::move(corners));
  all.floor -= margin;
  all.ceiling += margin;
  return all;
}

}  // namespace skein::supervisor
