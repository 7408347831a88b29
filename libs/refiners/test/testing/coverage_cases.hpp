// SPDX-License-Identifier: Apache-2.0
// Areas to sweep, and an oracle of what a sweep covers that shares nothing with the refiner.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/coverage.hpp"

namespace skein::refiners::testing {

using world::Polygon;
using world::Vector2;
using world::Vector3;

/// Corners on a circle squeezed to an ellipse at some angle: convex, 3 to 12 corners.
inline Polygon random_convex(Random& random, double size = 400) {
  std::vector<double> angles(3 + random.below(10));
  double widest = 0;
  do {
    for (double& angle : angles) angle = random.uniform(0, 2 * std::numbers::pi);
    std::sort(angles.begin(), angles.end());
    widest = angles.front() + 2 * std::numbers::pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i)
      widest = std::max(widest, angles[i] - angles[i - 1]);
  } while (widest > 0.95 * std::numbers::pi);
  const double a = size * random.uniform(0.5, 1.5), b = a * random.uniform(0.3, 1);
  const double turn = random.uniform(0, std::numbers::pi);
  Polygon polygon;
  for (const double angle : angles) {
    const double x = a * std::cos(angle), y = b * std::sin(angle);
    polygon.emplace_back(x * std::cos(turn) - y * std::sin(turn),
                         x * std::sin(turn) + y * std::cos(turn));
  }
  return polygon;
}

/// Corners at random distances all around: simple, rarely convex.
inline Polygon random_star(Random& random, std::size_t corners, double least = 150,
                           double most = 500) {
  Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi *
                         (static_cast<double>(i) + random.uniform(-0.3, 0.3)) /
                         static_cast<double>(corners);
    const double distance = random.uniform(least, most);
    polygon.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
  }
  return polygon;
}

inline Polygon rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

/// By gift wrapping: nothing of the refiner is used for its own baseline.
inline Polygon wrapped_hull(const Polygon& polygon) {
  std::size_t at = 0;
  for (std::size_t k = 1; k < polygon.size(); ++k)
    if (polygon[k].x() < polygon[at].x()) at = k;
  const std::size_t first = at;
  Polygon hull;
  do {
    hull.push_back(polygon[at]);
    std::size_t next = (at + 1) % polygon.size();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vector2 a = polygon[next] - polygon[at], b = polygon[k] - polygon[at];
      if (a.x() * b.y() - a.y() * b.x() < 0) next = k;
    }
    at = next;
  } while (at != first);
  return hull;
}

inline bool is_to_be_swept(const CoverageQuery& query, const Vector2& point) {
  if (!world::contains(query.area, point)) return false;
  return std::none_of(query.holes.begin(), query.holes.end(),
                      [&](const Polygon& hole) { return world::contains(hole, point); });
}

/// In the rectangle of half a swath on either side of a lane, and not beyond its ends.
inline bool is_swept(const Vector2& point, const std::vector<Lane>& lanes, double swath) {
  constexpr double kRounding = 1e-6;
  return std::any_of(lanes.begin(), lanes.end(), [&](const Lane& lane) {
    const Vector2 along = lane.to - lane.from, offset = point - lane.from;
    const double length = along.norm();
    if (length == 0) return offset.norm() <= swath / 2;
    const double run = along.dot(offset) / length;
    const double side = (along.x() * offset.y() - along.y() * offset.x()) / length;
    return run >= -kRounding && run <= length + kRounding &&
           std::abs(side) <= swath / 2 + kRounding;
  });
}

/// Part of the points of a raster in the area, about `points` of them, that a sweep covers.
inline double covered(const CoverageQuery& query, const Coverage& sweep, double points = 10'000) {
  Vector2 low = query.area[0], high = query.area[0];
  for (const Vector2& corner : query.area) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double cell = std::sqrt((high - low).prod() / points);
  double inside = 0, swept = 0;
  for (double y = low.y() + cell / 2; y < high.y(); y += cell)
    for (double x = low.x() + cell / 2; x < high.x(); x += cell) {
      if (!is_to_be_swept(query, {x, y})) continue;
      inside += 1;
      swept += is_swept({x, y}, sweep.lanes, query.swath) ? 1 : 0;
    }
  return inside > 0 ? swept / inside : 1;
}

}  // namespace skein::refiners::testing
