// SPDX-License-Identifier: Apache-2.0
#include "skein/world/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skein/world/segment.hpp"

namespace skein::world {

namespace {

// The part [first, last] of the segment, as fractions, that is between the two levels.
bool clip(double from, double to, double low, double high, double& first, double& last) {
  const double rise = to - from;
  if (rise == 0) return from >= low && from <= high;
  const double a = (low - from) / rise, b = (high - from) / rise;
  first = std::max(first, std::min(a, b));
  last = std::min(last, std::max(a, b));
  return first <= last;
}

}  // namespace

bool crosses(const Volume& volume, double margin, const Vector3& from, const Vector3& to) {
  double first = 0, last = 1;
  if (!clip(from.z(), to.z(), volume.floor - margin, volume.ceiling + margin, first, last)) {
    return false;
  }
  const Vector2 a = (from + first * (to - from)).head<2>();
  const Vector2 b = (from + last * (to - from)).head<2>();
  const Polygon& corners = volume.polygon;
  if (contains(corners, a) || contains(corners, b)) return true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2& next = corners[(i + 1) % corners.size()];
    if (between_segments(a, b, corners[i], next) <= margin) return true;
  }
  return false;
}

bool crosses(const Volume& volume, double margin, const std::vector<Vector3>& way) {
  if (way.size() == 1) return crosses(volume, margin, way[0], way[0]);
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (crosses(volume, margin, way[i - 1], way[i])) return true;
  }
  return false;
}

std::vector<Vector3> rest_of(const std::vector<Vector3>& way, const Vector3& position) {
  std::vector<Vector3> rest{position};
  std::size_t next = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double off = to_segment(position, way[i - 1], way[i]);
    if (off < best) {
      best = off;
      next = i;
    }
  }
  for (std::size_t i = next; i < way.size(); ++i) rest.push_back(way[i]);
  return rest;
}

}  // namespace skein::world
