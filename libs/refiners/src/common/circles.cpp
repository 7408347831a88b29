// SPDX-License-Identifier: Apache-2.0
#include "common/circles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skein::refiners {

using world::Vector2;
using world::Vector3;

void add_circles(Way& way, double to, const Vector2& ahead, double slope, double radius) {
  const Vector3 at = way.back();
  const double rise = to - at.z();
  const double step =
      std::min(std::numbers::pi / 8, 2 * std::acos(1 - std::min(1.0, kTurnTolerance / radius)));
  const double in_turn = std::ceil(2 * std::numbers::pi / step);
  const double run = in_turn * 2 * radius * std::sin(std::numbers::pi / in_turn);
  const double turns = std::ceil(std::abs(rise) / (run * slope));
  const Vector2 left(-ahead.y(), ahead.x());
  const Vector2 centre = at.head<2>() + radius * left;
  const double pieces = turns * in_turn;
  for (double i = 1; i <= pieces; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / pieces;
    const Vector2 point = centre + radius * (std::sin(angle) * ahead - std::cos(angle) * left);
    way.emplace_back(point.x(), point.y(), at.z() + rise * i / pieces);
  }
  way.back() = {at.x(), at.y(), to};
}

}  // namespace skein::refiners
