// SPDX-License-Identifier: Apache-2.0
#include "skein/world/polygon_check.hpp"

#include <algorithm>
#include <cmath>

namespace skein::world {
namespace {

struct Segment {
  Vector2 from, to;
  Vector2 low() const { return from.cwiseMin(to); }
  Vector2 high() const { return from.cwiseMax(to); }
};

double distance(const Segment& segment, const Vector2& point) {
  const Vector2 along = segment.to - segment.from;
  const double length2 = along.squaredNorm();
  const double t =
      length2 > 0 ? std::clamp(along.dot(point - segment.from) / length2, 0.0, 1.0) : 0;
  return (segment.from + t * along - point).norm();
}

/// Greater than zero: the point is to the left.
double side(const Segment& segment, const Vector2& point) {
  const Vector2 along = segment.to - segment.from, offset = point - segment.from;
  return along.x() * offset.y() - along.y() * offset.x();
}

bool cross(const Segment& a, const Segment& b) {
  return (side(a, b.from) > 0) != (side(a, b.to) > 0) &&
         (side(b, a.from) > 0) != (side(b, a.to) > 0);
}

bool cross_or_touch(const Segment& a, const Segment& b) {
  const Vector2 reach = Vector2::Constant(kTouching);
  if (((a.low() - reach).array() > b.high().array()).any() ||
      ((b.low() - reach).array() > a.high().array()).any())
    return false;
  return cross(a, b) || distance(a, b.from) <= kTouching || distance(a, b.to) <= kTouching ||
         distance(b, a.from) <= kTouching || distance(b, a.to) <= kTouching;
}

/// "corner 3", counted from 1 and round the end.
std::string corner(std::size_t index, std::size_t count) {
  return "corner " + std::to_string(index % count + 1);
}

std::optional<std::string> repeated(const Polygon& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  if ((polygon[i] - polygon[(i + 1) % n]).norm() > kTouching) return std::nullopt;
  return corner(i, n) + " and " + corner(i + 1, n) + " are the same place";
}

std::optional<std::string> folded_back(const Polygon& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  const Vector2 &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
  if (distance({a, b}, c) <= kTouching || distance({b, c}, a) <= kTouching)
    return "the border folds back at " + corner(i + 1, n);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> problem_of(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return std::to_string(n) + " corners enclose nothing: at least three";
  if (n > kMostCorners)
    return std::to_string(n) + " corners: at most " + std::to_string(kMostCorners);
  for (std::size_t i = 0; i < n; ++i)
    if (!polygon[i].allFinite()) return corner(i, n) + " is not two finite numbers";
  for (std::size_t i = 0; i < n; ++i)
    if (auto problem = repeated(polygon, i)) return problem;
  for (std::size_t i = 0; i < n; ++i)
    if (auto problem = folded_back(polygon, i)) return problem;
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      if (cross_or_touch({polygon[i], polygon[i + 1]}, {polygon[j], polygon[(j + 1) % n]}))
        return "the edges after " + corner(i, n) + " and " + corner(j, n) + " cross or touch";
    }
  if (!(area(polygon) > 0)) return "the corners enclose no area";
  return std::nullopt;
}

}  // namespace skein::world
