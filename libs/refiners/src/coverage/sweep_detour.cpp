// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_detour.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coverage/sweep_planner.hpp"

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

constexpr std::size_t kMostCorners = 400;

Vector2 outward(const Vector2& from, const Vector2& to) {
  const Vector2 along = (to - from).normalized();
  return {along.y(), -along.x()};
}

/// The corners of the hull, moved out: two for each, so that a sharp one is not left far away.
void add_corners(const Polygon& outline, double margin, std::vector<Vector2>& corners) {
  const Polygon hull = convex_hull(outline);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2& before = hull[(i + hull.size() - 1) % hull.size()];
    const Vector2& after = hull[(i + 1) % hull.size()];
    const Vector2 in = outward(before, hull[i]), out = outward(hull[i], after);
    const Vector2 middle = (in + out).normalized();
    for (const Vector2& side : {in, out}) {
      const Vector2 between = (side + middle).normalized();
      corners.push_back(hull[i] + margin / between.dot(side) * between);
    }
  }
}

}  // namespace

std::optional<std::vector<Vector2>> way_around(const Obstacles& obstacles, const Vector2& from,
                                               const Vector2& to, double margin) {
  std::vector<Vector2> points{from, to};
  for (const Polygon& outline : obstacles.outlines) add_corners(outline, margin, points);
  if (points.size() > kMostCorners) return std::nullopt;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> length(points.size(), kInfinity);
  std::vector<std::size_t> before(points.size(), 0);
  std::vector<bool> done(points.size(), false);
  length[0] = 0;
  while (!done[1]) {  // Source: Dijkstra 1959; lines are checked only where they would be shorter
    std::size_t at = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!done[i] && length[i] < (at < points.size() ? length[at] : kInfinity)) at = i;
    if (at == points.size()) return std::nullopt;
    done[at] = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double longer = length[at] + (points[i] - points[at]).norm();
      if (done[i] || longer >= length[i] || !obstacles.is_free(points[at], points[i])) continue;
      length[i] = longer;
      before[i] = at;
    }
  }
  std::vector<Vector2> way{to};
  for (std::size_t at = 1; at != 0; at = before[at]) way.push_back(points[before[at]]);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace skein::refiners
