// SPDX-License-Identifier: Apache-2.0
#include "partition/cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace skein::refiners::partition {
namespace {

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

const Vector2& after(const Polygon& polygon, std::size_t i) {
  return polygon[i + 1 == polygon.size() ? 0 : i + 1];
}

Vector2 crossing(const Vector2& p, const Vector2& q, double p_above, double q_above) {
  return p + (q - p) * (p_above / (p_above - q_above));
}

Vector2 nearest_on_edge(const Vector2& p, const Vector2& q, const Vector2& point) {
  const Vector2 along = q - p;
  const double length = along.squaredNorm();
  if (length == 0) return p;
  return p + along * std::clamp((point - p).dot(along) / length, 0.0, 1.0);
}

/// Adds up the area of a polygon from its corners one after the other.
class Shoelace {
 public:
  void add(const Vector2& point) {
    if (started_)
      twice_ += cross(last_ - first_, point - first_);
    else
      first_ = point;
    started_ = true;
    last_ = point;
  }
  double area() const { return twice_ / 2; }

 private:
  Vector2 first_ = Vector2::Zero(), last_ = Vector2::Zero();
  bool started_ = false;
  double twice_ = 0;
};

/// The levels of two neighbouring corners between which the area below reaches `area`.
std::pair<double, double> slab_of(const Polygon& polygon, double angle, double area) {
  std::vector<double> levels;
  levels.reserve(polygon.size());
  for (const Vector2& corner : polygon) levels.push_back(normal(angle).dot(corner));
  std::sort(levels.begin(), levels.end());
  const auto above = std::partition_point(levels.begin() + 1, levels.end() - 1, [&](double level) {
    return area_below(polygon, {angle, level}) < area;
  });
  return {*(above - 1), *above};
}

}  // namespace

double signed_area(const Polygon& polygon) {
  Shoelace sum;
  for (const Vector2& corner : polygon) sum.add(corner);
  return sum.area();
}

double area_below(const Polygon& polygon, const Cut& cut) {
  const Vector2 up = normal(cut.angle);
  Shoelace sum;
  double p_above = up.dot(polygon[0]) - cut.offset;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &p = polygon[i], &q = after(polygon, i);
    const double q_above = up.dot(q) - cut.offset;
    if (p_above <= 0) sum.add(p);
    if ((p_above < 0 && q_above > 0) || (p_above > 0 && q_above < 0))
      sum.add(crossing(p, q, p_above, q_above));
    p_above = q_above;
  }
  return sum.area();
}

Cut cut_with_area(const Polygon& polygon, double angle, double area) {
  // Between the levels of two corners the width is linear, so the area below is a parabola.
  const auto [low, high] = slab_of(polygon, angle, area);
  const double step = high - low;
  const double base = area_below(polygon, {angle, low});
  const double half = area_below(polygon, {angle, low + step / 2}) - base;
  const double full = area_below(polygon, {angle, high}) - base;
  const double b = 4 * half - full, a = full - b;  // a s² + b s at the fraction s of the slab
  const double wanted = area - base;
  const double root = std::sqrt(std::max(0.0, b * b + 4 * a * wanted));
  double s = b + root > 0 ? std::clamp(2 * wanted / (b + root), 0.0, 1.0) : 0.5;
  for (int polish = 0; polish < 2; ++polish) {
    const double slope = b + 2 * a * s;
    if (!(slope > 0)) break;
    const double error = area_below(polygon, {angle, low + s * step}) - area;
    s = std::clamp(s - error / slope, 0.0, 1.0);
  }
  return {angle, low + s * step};
}

std::pair<Polygon, Polygon> halves(const Polygon& polygon, const Cut& cut, double snap) {
  const Vector2 up = normal(cut.angle);
  const auto above = [&](const Vector2& corner) {
    const double height = up.dot(corner) - cut.offset;
    return std::abs(height) <= snap ? 0.0 : height;
  };
  std::pair<Polygon, Polygon> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &p = polygon[i], &q = after(polygon, i);
    const double p_above = above(p), q_above = above(q);
    if (p_above <= 0) result.first.push_back(p);
    if (p_above >= 0) result.second.push_back(p);
    if (p_above * q_above >= 0) continue;
    const Vector2 on_line = crossing(p, q, p_above, q_above);
    result.first.push_back(on_line);
    result.second.push_back(on_line);
  }
  return result;
}

bool is_inside(const Polygon& polygon, const Vector2& point) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (cross(after(polygon, i) - polygon[i], point - polygon[i]) < 0) return false;
  return true;
}

Vector2 nearest_on_border(const Polygon& polygon, const Vector2& point) {
  Vector2 best = polygon[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 candidate = nearest_on_edge(polygon[i], after(polygon, i), point);
    const double distance = (candidate - point).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = candidate;
  }
  return best;
}

Vector2 nearest_inside(const Polygon& polygon, const Vector2& point) {
  return is_inside(polygon, point) ? point : nearest_on_border(polygon, point);
}

double perimeter(const Polygon& polygon) {
  double length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    length += (after(polygon, i) - polygon[i]).norm();
  return length;
}

}  // namespace skein::refiners::partition
