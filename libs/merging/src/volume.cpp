// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/volume.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/world/segment.hpp"

namespace skein::merging {

bool overlap(const Volume& one, const Volume& other) {
  if (one.ceiling <= other.floor || other.ceiling <= one.floor) return false;
  return world::between_segments(one.from, one.to, other.from, other.to) <
         one.radius + other.radius;
}

bool overlap(const Volumes& some, const Volumes& others) {
  return std::any_of(some.begin(), some.end(), [&](const Volume& one) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Volume& other) { return overlap(one, other); });
  });
}

bool contains(const Volume& outer, const Volume& inner) {
  if (inner.floor < outer.floor || inner.ceiling > outer.ceiling) return false;
  const auto near = [&](const world::Vector2& end) {
    return world::between_segments(outer.from, outer.to, end, end) + inner.radius <= outer.radius;
  };
  return near(inner.from) && near(inner.to);
}

world::Volume closed_around(const Volume& volume, double wider, double higher) {
  constexpr int kSides = 6;  // of each end
  constexpr double kHalf = std::numbers::pi / 2 / kSides;
  const double radius = (volume.radius + wider) / std::cos(kHalf);
  const world::Vector2 along = volume.to - volume.from;
  const double heading = along.isZero() ? 0 : std::atan2(along.y(), along.x());
  world::Volume closed;
  closed.floor = volume.floor - higher;
  closed.ceiling = volume.ceiling + higher;
  // Sides touch the circle: from the left of each end to its right.
  for (const bool at_end : {true, false}) {
    const double first = heading + (at_end ? -std::numbers::pi / 2 : std::numbers::pi / 2);
    for (int i = 0; i < kSides; ++i) {
      const double angle = first + (2 * i + 1) * kHalf;
      closed.polygon.push_back((at_end ? volume.to : volume.from) +
                               radius * world::Vector2(std::cos(angle), std::sin(angle)));
    }
  }
  return closed;
}

}  // namespace skein::merging
