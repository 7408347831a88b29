// SPDX-License-Identifier: Apache-2.0
#include "patrol/space.hpp"

#include <algorithm>
#include <limits>

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

bool turns_one_way(const Polygon& polygon) {
  bool left = false, right = false;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 in = polygon[(i + 1) % n] - polygon[i];
    const Vector2 out = polygon[(i + 2) % n] - polygon[(i + 1) % n];
    const double turn = cross(in, out);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return !(left && right);
}

/// Fractions of the segment where it meets the edges of a polygon; of a stretch along an edge, both
/// ends.
std::vector<double> meetings(const Polygon& polygon, const Vector2& from, const Vector2& to) {
  std::vector<double> found;
  const Vector2 step = to - from;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2 edge = polygon[(i + 1) % polygon.size()] - a;
    const double slant = cross(step, edge);
    if (slant == 0) {
      if (cross(a - from, step) != 0 || step.squaredNorm() == 0) continue;
      for (const Vector2& end : {a, Vector2(a + edge)})
        found.push_back((end - from).dot(step) / step.squaredNorm());
      continue;
    }
    const double along_edge = cross(a - from, step) / slant;
    if (along_edge >= 0 && along_edge <= 1) found.push_back(cross(a - from, edge) / slant);
  }
  std::erase_if(found, [](double t) { return t < 0 || t > 1; });
  return found;
}

double distance_to_edge(const Vector2& a, const Vector2& b, const Vector2& at) {
  const Vector2 edge = b - a;
  const double along = std::clamp((at - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (a + along * edge - at).norm();
}

}  // namespace

PatrolSpace::PatrolSpace(Polygon zone, std::vector<Polygon> closed)
    : zone_(std::move(zone)), closed_(std::move(closed)), convex_(turns_one_way(zone_)) {}

bool PatrolSpace::is_clear(const Vector2& at) const {
  return std::none_of(closed_.begin(), closed_.end(),
                      [&](const Polygon& polygon) { return world::contains(polygon, at); });
}

bool PatrolSpace::is_clear(const Vector2& from, const Vector2& to) const {
  return is_clear(from) && is_clear(to) &&
         std::all_of(closed_.begin(), closed_.end(),
                     [&](const Polygon& polygon) { return meetings(polygon, from, to).empty(); });
}

bool PatrolSpace::is_open(const Vector2& at) const {
  return world::contains(zone_, at) && is_clear(at);
}

bool PatrolSpace::is_open(const Vector2& from, const Vector2& to) const {
  return is_clear(from, to) && stays_in_zone(from, to);
}

bool PatrolSpace::stays_in_zone(const Vector2& from, const Vector2& to) const {
  if (!world::contains(zone_, from) || !world::contains(zone_, to)) return false;
  if (convex_) return true;
  std::vector<double> fractions = meetings(zone_, from, to);
  fractions.push_back(0);
  fractions.push_back(1);
  std::sort(fractions.begin(), fractions.end());
  for (std::size_t i = 1; i < fractions.size(); ++i)
    if (!world::contains(zone_, from + (fractions[i - 1] + fractions[i]) / 2 * (to - from)))
      return false;
  return true;
}

double PatrolSpace::outside(const Vector2& at) const {
  if (world::contains(zone_, at)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zone_.size(); ++i)
    least = std::min(least, distance_to_edge(zone_[i], zone_[(i + 1) % zone_.size()], at));
  return least;
}

}  // namespace skein::refiners
