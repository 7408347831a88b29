// SPDX-License-Identifier: Apache-2.0
#include "skein/world/landing_ground.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skein::world {

namespace {

constexpr double kFinest = 1;      // [m] between points that are looked at
constexpr double kOfRadius = 0.5;  // at most, so that the rim is looked at in large cells too

std::string outside() { return "no landing outside the terrain"; }

std::string too_steep(double slope) {
  const double tenths = std::round(slope * 1800 / std::numbers::pi) / 10;
  std::string figure = std::to_string(tenths);
  figure.erase(figure.find('.') + 2);
  return "the ground slopes by " + figure + " degrees, too steep to land";
}

}  // namespace

std::optional<std::string> landing_problem(const Terrain& terrain, const Vector2& at) {
  if (!terrain.contains(at.x(), at.y())) return outside();
  const double slope = terrain.slope(at.x(), at.y());
  if (slope > kSteepestLanding) return too_steep(slope);
  return std::nullopt;
}

std::optional<std::string> landing_problem(const Terrain& terrain, const Vector2& centre,
                                           double radius) {
  if (radius <= 0) return landing_problem(terrain, centre);
  const double step = std::max(kFinest, std::min(terrain.spec().cell / 4, radius * kOfRadius));
  const int steps = static_cast<int>(std::ceil(radius / step));
  double steepest = 0;
  for (int row = -steps; row <= steps; ++row) {
    for (int column = -steps; column <= steps; ++column) {
      // Within the step that is begun counts too: the rim is not left out.
      const Vector2 off(column * step, row * step);
      if (off.norm() > radius + step / 2) continue;
      const Vector2 at = centre + off;
      if (!terrain.contains(at.x(), at.y())) return outside();
      steepest = std::max(steepest, terrain.slope(at.x(), at.y()));
    }
  }
  return steepest > kSteepestLanding ? std::optional(too_steep(steepest)) : std::nullopt;
}

}  // namespace skein::world
