// SPDX-License-Identifier: Apache-2.0
// Straight cuts through a convex polygon.
#pragma once

#include <cmath>
#include <utility>

#include "skein/world/geometry.hpp"

namespace skein::refiners::partition {

using world::Polygon;
using world::Vector2;

/// A line: the points x with normal(angle) · x = offset. What is below has less.
struct Cut {
  double angle = 0;  ///< of the normal [rad]
  double offset = 0;
};

inline Vector2 normal(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Positive when the corners are counter-clockwise. Exact figures need corners near the origin.
double signed_area(const Polygon& polygon);

/// Of what is below the line. Precondition of this and the rest: convex, counter-clockwise.
double area_below(const Polygon& polygon, const Cut& cut);

/// The line with that normal and that area below, to rounding. 0 < area < the whole.
Cut cut_with_area(const Polygon& polygon, double angle, double area);

/// What is below the line and what is above. Corners within `snap` of it count as on it, so that no
/// edges shorter than that come up.
std::pair<Polygon, Polygon> halves(const Polygon& polygon, const Cut& cut, double snap);

/// Nearest to a point: itself when it is inside.
Vector2 nearest_inside(const Polygon& polygon, const Vector2& point);
Vector2 nearest_on_border(const Polygon& polygon, const Vector2& point);
bool is_inside(const Polygon& polygon, const Vector2& point);

double perimeter(const Polygon& polygon);

}  // namespace skein::refiners::partition
