// SPDX-License-Identifier: Apache-2.0
#include "skein/world/fire.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skein::world {
namespace {

constexpr double kMostSlender = 8;  // length to breadth, beyond which the formula is not measured

/// What does not change while it burns.
struct Shape {
  Vector2 ahead = Vector2::UnitX();
  double growth = 0;        ///< of half its length [m/s]
  double eccentricity = 0;  ///< [0, 1)

  double slenderness() const { return 1 / std::sqrt(1 - eccentricity * eccentricity); }
  /// How fast the front moves away from the ignition in this direction [m/s].
  double rate_toward(const Vector2& unit) const {
    return growth * (1 - eccentricity * eccentricity) / (1 - eccentricity * unit.dot(ahead));
  }
};

// By the wind at the height of the flames [m/s].
double slenderness_in(double wind) {
  const double ratio = 0.936 * std::exp(0.2566 * wind) + 0.461 * std::exp(-0.1548 * wind) - 0.397;
  return std::clamp(ratio, 1.0, kMostSlender);
}

Shape shape_of(const FireSpread& spread) {
  const double ratio = slenderness_in(spread.wind.speed);
  Shape shape;
  shape.ahead = Vector2(std::cos(spread.wind.toward), std::sin(spread.wind.toward));
  shape.eccentricity = std::sqrt(1 - 1 / (ratio * ratio));
  const double head = spread.rate * (1 + spread.gain * spread.wind.speed);
  shape.growth = head / (1 + shape.eccentricity);
  return shape;
}

Vector2 left_of(const Vector2& v) { return {-v.y(), v.x()}; }

/// From when it was a point until it reached `radius` ahead [s].
double kindling(const Shape& shape, double radius) {
  return radius / shape.rate_toward(shape.ahead);
}

}  // namespace

Vector2 FireFront::centre() const {
  return ignition + std::sqrt(std::max(0.0, length * length - breadth * breadth)) * ahead;
}

Vector2 FireFront::head() const { return centre() + length * ahead; }

bool FireFront::contains(const Vector2& point) const {
  if (length <= 0 || breadth <= 0) return false;
  const Vector2 off = point - centre();
  return std::hypot(off.dot(ahead) / length, off.dot(left_of(ahead)) / breadth) <= 1;
}

// In the quarter of the ellipse where the point is, by bisection on Lagrange's multiplier.
double FireFront::distance_to(const Vector2& point) const {
  if (contains(point)) return 0;
  const Vector2 off = point - centre();
  if (length <= 0 || breadth <= 0) return off.norm();
  const double x = std::abs(off.dot(ahead)), y = std::abs(off.dot(left_of(ahead)));
  const auto nearest_at = [&](double t) {
    return Vector2(length * length * x / (t + length * length),
                   breadth * breadth * y / (t + breadth * breadth));
  };
  double low = 0, high = std::hypot(length * x, breadth * y);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    const Vector2 at = nearest_at(middle);
    (std::hypot(at.x() / length, at.y() / breadth) > 1 ? low : high) = middle;
  }
  return (Vector2(x, y) - nearest_at(high)).norm();
}

std::vector<Vector2> FireFront::outline(std::size_t points) const {
  std::vector<Vector2> outline;
  outline.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    outline.push_back(centre() + length * std::cos(turn) * ahead +
                      breadth * std::sin(turn) * left_of(ahead));
  }
  return outline;
}

FireFront front_of(const FireSpread& spread, const Vector2& ignition, double radius, Duration age) {
  const Shape shape = shape_of(spread);
  const double burnt = std::max(0.0, age.to_seconds()) + kindling(shape, radius);
  FireFront front;
  front.ignition = ignition;
  front.ahead = shape.ahead;
  front.length = shape.growth * burnt;
  front.breadth = front.length / shape.slenderness();
  return front;
}

Duration arrival_at(const FireSpread& spread, const Vector2& ignition, double radius,
                    const Vector2& point) {
  const Shape shape = shape_of(spread);
  const Vector2 off = point - ignition;
  const double distance = off.norm();
  if (distance <= 0) return Duration::seconds(-kindling(shape, radius));
  const double seconds = distance / shape.rate_toward(off / distance) - kindling(shape, radius);
  constexpr double kForEver = 9e9;  // more than a Duration holds
  return seconds < kForEver ? Duration::seconds(seconds) : Duration::max();
}

}  // namespace skein::world
