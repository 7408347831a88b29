// SPDX-License-Identifier: Apache-2.0
#include "interaction/area_cutting.hpp"

#include <algorithm>

namespace skein::decision_node {

namespace {

using world::Polygon;
using world::Vector2;

/// One side of a line.
Polygon below(const Polygon& polygon, const Vector2& normal, double highest) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double over_a = a.dot(normal) - highest, over_b = b.dot(normal) - highest;
    if (over_a <= 0) kept.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0))
      kept.push_back(a + (b - a) * (over_a / (over_a - over_b)));
  }
  return kept;
}

/// The half-planes of which a convex polygon is what they have in common: normals outwards, and how
/// far they reach along them.
struct HalfPlane {
  Vector2 normal;
  double highest;
};
std::vector<HalfPlane> half_planes_of(const Polygon& convex) {
  double signed_area = 0;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vector2 &a = convex[i], &b = convex[(i + 1) % convex.size()];
    signed_area += a.x() * b.y() - a.y() * b.x();
  }
  const double outwards = signed_area > 0 ? 1 : -1;
  std::vector<HalfPlane> all;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vector2 along = (convex[(i + 1) % convex.size()] - convex[i]).normalized();
    const Vector2 normal = outwards * Vector2(along.y(), -along.x());
    all.push_back({normal, convex[i].dot(normal)});
  }
  return all;
}

bool is_convex(const Polygon& polygon) {
  const auto holds_all = [&](const HalfPlane& one) {
    return std::ranges::all_of(polygon, [&](const Vector2& corner) {
      return corner.dot(one.normal) <= one.highest + 1e-6;
    });
  };
  return std::ranges::all_of(half_planes_of(polygon), holds_all);
}

Polygon box_of(const Polygon& polygon) {
  Vector2 low = polygon.front(), high = low;
  for (const Vector2& corner : polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

bool is_something(const Polygon& polygon) {
  return polygon.size() > 2 && world::area(polygon) > kNoArea;
}

}  // namespace

Polygon between(const Polygon& polygon, const Vector2& normal, double lowest, double highest) {
  return below(below(polygon, normal, highest), -normal, -lowest);
}

double common_area(const Polygon& one, const Polygon& other) {
  Polygon common = one;
  for (const HalfPlane& half : half_planes_of(other))
    common = below(common, half.normal, half.highest);
  return common.size() < 3 ? 0 : world::area(common);
}

void cut_out(const Polygon& hole, double margin, std::vector<Polygon>& areas,
             std::vector<Polygon>& within) {
  const std::vector<HalfPlane> halves = half_planes_of(is_convex(hole) ? hole : box_of(hole));
  std::vector<Polygon> beside;
  for (Polygon& inner : areas) {
    for (const HalfPlane& half : halves) {
      const double edge = half.highest + margin;
      Polygon outer = below(inner, -half.normal, -edge);
      inner = below(inner, half.normal, edge);
      if (is_something(outer)) beside.push_back(std::move(outer));
    }
    if (is_something(inner)) within.push_back(std::move(inner));
  }
  areas = std::move(beside);
}

}  // namespace skein::decision_node
