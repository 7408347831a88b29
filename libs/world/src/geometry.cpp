// SPDX-License-Identifier: Apache-2.0
#include "skein/world/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skein::world {
namespace {

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

bool on_edge(const Vector2& from, const Vector2& to, const Vector2& point) {
  const Vector2 edge = to - from;
  const Vector2 offset = point - from;
  if (edge.isZero(0)) return offset.isZero(0);
  const double along = edge.dot(offset);
  const double length2 = edge.squaredNorm();
  return std::abs(cross(edge, offset)) <= 1e-9 * std::max(1.0, length2) && along >= 0 &&
         along <= length2;
}

}  // namespace

double wrapped(double angle) {
  const double turn = 2 * std::numbers::pi;
  double result = std::fmod(angle, turn);
  if (result > std::numbers::pi) result -= turn;
  if (result <= -std::numbers::pi) result += turn;
  return result;
}

Vector3 direction_of(double heading, double pitch) {
  return {std::cos(pitch) * std::cos(heading), std::cos(pitch) * std::sin(heading),
          std::sin(pitch)};
}

bool contains(const Polygon& polygon, const Vector2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2& b = polygon[(i + 1) % polygon.size()];
    if (on_edge(a, b, point)) return true;
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return std::abs(twice) / 2;
}

}  // namespace skein::world
