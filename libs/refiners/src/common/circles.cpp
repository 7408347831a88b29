// SPDX-License-Identifier: Apache-2.0
#include "common/circles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/heights_over.hpp"

namespace skein::refiners {

using world::Vector2;
using world::Vector3;

namespace {

/// Without where they begin. `side`: a unit vector to the side of the middle.
Way circles_beside(const Vector3& at, double to, const Vector2& ahead, const Vector2& side,
                   const CircleRule& rule) {
  const double rise = to - at.z(), radius = rule.radius;
  const double step =
      std::min(std::numbers::pi / 8, 2 * std::acos(1 - std::min(1.0, kTurnTolerance / radius)));
  const double in_turn = std::ceil(2 * std::numbers::pi / step);
  const double run = in_turn * 2 * radius * std::sin(std::numbers::pi / in_turn);
  const double turns = std::ceil(std::abs(rise) / (run * rule.slope));
  const Vector2 centre = at.head<2>() + radius * side;
  const double pieces = turns * in_turn;
  Way circles;
  for (double i = 1; i <= pieces; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / pieces;
    const Vector2 point = centre + radius * (std::sin(angle) * ahead - std::cos(angle) * side);
    circles.emplace_back(point.x(), point.y(), at.z() + rise * i / pieces);
  }
  circles.back() = {at.x(), at.y(), to};
  return circles;
}

double least_height(Vector3 before, const Way& way, const world::Terrain& terrain) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& point : way) {
    least = std::min(least, heights_over(terrain, before, point).least);
    before = point;
  }
  return least;
}

}  // namespace

void add_circles(Way& way, double to, const Vector2& ahead, const CircleRule& rule,
                 const world::Terrain& terrain) {
  const Vector3 at = way.back();
  const Vector2 left(-ahead.y(), ahead.x());
  Way circles = circles_beside(at, to, ahead, left, rule);
  const double height = least_height(at, circles, terrain);
  if (height < rule.least) {
    Way right = circles_beside(at, to, ahead, -left, rule);
    if (least_height(at, right, terrain) > height) circles = std::move(right);
  }
  way.insert(way.end(), circles.begin(), circles.end());
}

}  // namespace skein::refiners
