// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_headland.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

constexpr double kTouch = 1e-6;  // [m]

/// How far inside an edge of a counter-clockwise polygon [m].
double inside_of(const Vector2& a, const Vector2& b, const Vector2& point) {
  const Vector2 edge = b - a, offset = point - a;
  return (edge.x() * offset.y() - edge.y() * offset.x()) / edge.norm();
}

/// What of a polygon is at least `width` inside an edge. Source: Sutherland and Hodgman 1974.
Polygon cut(const Polygon& polygon, const Vector2& a, const Vector2& b, double width) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double in_p = inside_of(a, b, p) - width, in_q = inside_of(a, b, q) - width;
    if (in_p >= 0) kept.push_back(p);
    if ((in_p > 0 && in_q < 0) || (in_p < 0 && in_q > 0))
      kept.emplace_back(p + (q - p) * (in_p / (in_p - in_q)));
  }
  return kept;
}

/// How far beyond a corner that turns by so much lanes half a swath inside are flown [m].
double beyond_corner(double turn, double half_swath) {
  const double until_strips_meet = half_swath * std::tan(turn / 2);
  const bool sharp = turn > std::numbers::pi / 2;
  return sharp ? std::min(until_strips_meet, half_swath / std::sin(turn)) : until_strips_meet;
}

}  // namespace

Polygon without_headland(const Polygon& area, double width) {
  Polygon left = area;
  for (std::size_t i = 0; i < area.size() && left.size() > 2; ++i)
    left = cut(left, area[i], area[(i + 1) % area.size()], width);
  const auto same = [](const Vector2& a, const Vector2& b) { return (a - b).norm() < kTouch; };
  left.erase(std::unique(left.begin(), left.end(), same), left.end());
  while (left.size() > 1 && same(left.front(), left.back())) left.pop_back();
  return left;
}

std::vector<Pass> border_lap(const Polygon& area, double swath, const Vector2& from) {
  const Polygon ring = without_headland(area, swath / 2);
  const std::size_t n = ring.size();
  if (n < 3) return {};
  const auto corner = [&](std::size_t i) -> const Vector2& { return ring[i % n]; };
  const auto heading = [&](std::size_t i) {
    const Vector2 edge = corner(i + 1) - corner(i);
    return std::atan2(edge.y(), edge.x());
  };
  const auto nearest = std::min_element(
      ring.begin(), ring.end(),
      [&](const Vector2& a, const Vector2& b) { return (a - from).norm() < (b - from).norm(); });
  const auto first = static_cast<std::size_t>(nearest - ring.begin());
  std::vector<Pass> lap;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = first + k;
    const double along = heading(i);
    const Vector2 ahead(std::cos(along), std::sin(along));
    const auto turn_at = [&](std::size_t at) {
      return std::clamp(world::wrapped(heading(at) - heading(at + n - 1)), 0.0,
                        std::numbers::pi - kTouch);
    };
    lap.push_back({corner(i) - beyond_corner(turn_at(i), swath / 2) * ahead,
                   corner(i + 1) + beyond_corner(turn_at(i + 1), swath / 2) * ahead, along});
  }
  return lap;
}

bool sweeps_within(const Polygon& area, const Coverage& coverage) {
  const auto is_at = [](const Vector2& place) {
    return
        [&place](const world::Vector3& point) { return (point.head<2>() - place).norm() < kTouch; };
  };
  const Way& way = coverage.way;
  const auto first = std::find_if(way.begin(), way.end(), is_at(coverage.lanes.front().from));
  const auto last = std::find_if(way.rbegin(), way.rend(), is_at(coverage.lanes.back().to));
  return std::all_of(first, last.base(), [&](const world::Vector3& point) {
    for (std::size_t i = 0; i < area.size(); ++i)
      if (inside_of(area[i], area[(i + 1) % area.size()], point.head<2>()) < -kTouch) return false;
    return true;
  });
}

}  // namespace skein::refiners
