// SPDX-License-Identifier: Apache-2.0
// Shapes of regions: convex or not, their hull, the longest line inside.
#include <algorithm>
#include <cmath>
#include <utility>

#include "coverage/sweep_planner.hpp"

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The part of the line through a and b, as fractions of ab, that holds ab and stays inside; none
/// when ab does not. Only crossings proper end it: it may touch corners and run along edges.
std::optional<std::pair<double, double>> inside_part(const Region& region,
                                                     const std::vector<const Polygon*>& borders,
                                                     const Vector2& a, const Vector2& b) {
  const Vector2 line = b - a;
  std::vector<double> cuts;
  for (const Polygon* border : borders)
    for (std::size_t i = 0; i < border->size(); ++i) {
      const Vector2 p = (*border)[i] - a, q = (*border)[(i + 1) % border->size()] - a;
      const double side_p = cross(line, p), side_q = cross(line, q);
      if ((side_p > 0) == (side_q > 0) && side_p != 0 && side_q != 0) continue;
      if (side_p == 0) cuts.push_back(p.dot(line) / line.squaredNorm());
      if (side_p == side_q || side_p == 0 || side_q == 0) continue;
      const Vector2 crossing = p + (q - p) * (side_p / (side_p - side_q));
      cuts.push_back(crossing.dot(line) / line.squaredNorm());
    }
  std::sort(cuts.begin(), cuts.end());
  const auto is_inside = [&](double fraction) {
    const Vector2 point = a + fraction * line;
    if (!world::contains(region.outer, point)) return false;
    return std::none_of(region.holes.begin(), region.holes.end(),
                        [&](const Polygon& hole) { return world::contains(hole, point); });
  };
  double from = 0, to = 0;
  bool holds = false;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] - cuts[i] < 1e-12) continue;
    const bool inside = is_inside((cuts[i] + cuts[i + 1]) / 2);
    if (!inside && holds && to >= 1 - 1e-9) break;
    if (inside && !holds) from = cuts[i];
    if (inside) to = cuts[i + 1];
    holds = inside;
  }
  if (from > 1e-9 || to < 1 - 1e-9) return std::nullopt;
  return std::pair{from, to};
}

}  // namespace

Polygon convex_hull(const Polygon& polygon) {
  Polygon sorted = polygon;
  std::sort(sorted.begin(), sorted.end(), [](const Vector2& a, const Vector2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Polygon hull;
  const auto add = [&](const Vector2& point, std::size_t fixed) {
    while (hull.size() >= fixed + 2 &&
           cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const Vector2& point : sorted) add(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto point = sorted.rbegin() + 1; point != sorted.rend(); ++point) add(*point, lower);
  hull.pop_back();
  return hull;
}

bool is_convex(const Polygon& polygon) {
  const double whole = world::area(convex_hull(polygon));
  return whole - world::area(polygon) <= 1e-12 * whole;
}

double longest_line(const Region& region) {
  std::vector<const Polygon*> borders{&region.outer};
  for (const Polygon& hole : region.holes) borders.push_back(&hole);
  const bool convex = region.holes.empty() && is_convex(region.outer);
  Polygon corners;
  for (const Polygon* border : borders)
    corners.insert(corners.end(), border->begin(), border->end());
  double longest = 0, direction = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const Vector2 line = corners[j] - corners[i];
      double length = line.norm();
      if (!convex && length > 0) {
        const auto part = inside_part(region, borders, corners[i], corners[j]);
        length = part ? length * (part->second - part->first) : 0;
      }
      if (length <= longest) continue;
      longest = length;
      direction = std::atan2(line.y(), line.x());
    }
  return direction;
}

}  // namespace skein::refiners
