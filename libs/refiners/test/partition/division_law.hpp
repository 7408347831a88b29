// SPDX-License-Identifier: Apache-2.0
// Independent checks of a division: areas by the shoelace formula about a corner, disjointness by a
// separating edge.
#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "partition/divide.hpp"
#include "test_cases.hpp"
#include "testing/partition_cases.hpp"

namespace skein::refiners::division {

using partition::Division;
using partition::divisions;
using world::Polygon;
using world::Vector2;

inline const Polygon kSquare = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};

struct Case {
  Polygon area;
  std::vector<Vector2> anchors;
  std::vector<double> shares;
};

inline int cases(int few, int all) { return skein::testing::cases(few, all); }

inline double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += testing::turn(polygon[0], polygon[i], polygon[i + 1]);
  return std::abs(twice) / 2;
}

/// How far a point is inside a convex polygon of either sense; negative: at least that far outside
/// an edge.
inline double depth_in(const Polygon& polygon, const Vector2& point) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += testing::turn(polygon[0], polygon[i], polygon[i + 1]);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double length = (q - p).norm();
    const double side = std::copysign(1.0, twice) * testing::turn(p, q, point);
    if (length > 1e-7) least = std::min(least, side / length);
  }
  return least;
}

/// True when an edge of one leaves all of the other outside, but for `slack` [m].
inline bool apart(const Polygon& a, const Polygon& b, double slack) {
  const auto edge_leaves_out = [slack](const Polygon& one, const Polygon& other) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      const Vector2 &p = one[i], &q = one[(i + 1) % one.size()];
      const double length = (q - p).norm();
      const bool out = std::all_of(other.begin(), other.end(), [&](const Vector2& corner) {
        return testing::turn(p, q, corner) <= slack * length;
      });
      if (length > 1e-7 && out) return true;
    }
    return false;
  };
  return edge_leaves_out(a, b) || edge_leaves_out(b, a);
}

inline ::testing::AssertionResult lawful_part(const Polygon& part, const Vector2& anchor,
                                              double wanted, double slack) {
  if (part.size() < 3) return ::testing::AssertionFailure() << "is no polygon";
  const double error = std::abs(area_of(part) - wanted) / wanted;
  if (!(error <= 1e-9)) return ::testing::AssertionFailure() << "area is off by " << error;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vector2 &p = part[i], &q = part[(i + 1) % part.size()];
    const Vector2& r = part[(i + 2) % part.size()];
    if (testing::turn(p, q, r) < -slack * (r - p).norm())
      return ::testing::AssertionFailure() << "corner " << i + 1 << " turns inwards";
  }
  if (depth_in(part, anchor) < -slack)
    return ::testing::AssertionFailure()
           << "its anchor is " << -depth_in(part, anchor) << " m outside";
  return ::testing::AssertionSuccess();
}

/// The laws of divide(): areas, convex, anchored, disjoint, within the area; so they fill it.
inline ::testing::AssertionResult lawful(const Polygon& area, const std::vector<Vector2>& anchors,
                                         const std::vector<double>& shares,
                                         const std::vector<Polygon>& parts) {
  if (parts.size() != shares.size()) return ::testing::AssertionFailure() << "wrong count";
  const double slack = 1e-7, whole = area_of(area);
  double total = 0;
  for (const double share : shares) total += share;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto result = lawful_part(parts[i], anchors[i], shares[i] / total * whole, slack);
    if (!result) return ::testing::AssertionFailure() << "part " << i << ": " << result.message();
    for (const Vector2& corner : parts[i])
      if (depth_in(area, corner) < -slack)
        return ::testing::AssertionFailure() << "part " << i << " is out of the area";
    for (std::size_t k = 0; k < i; ++k)
      if (!apart(parts[i], parts[k], slack))
        return ::testing::AssertionFailure() << "parts " << k << " and " << i << " overlap";
  }
  return ::testing::AssertionSuccess();
}

/// The area of a polygon on the side of a line where `up` · x <= level (Sutherland and Hodgman).
inline double area_under(const Polygon& polygon, const Vector2& up, double level) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = up.dot(p) - level, b = up.dot(q) - level;
    if (a <= 0) kept.push_back(p);
    if ((a < 0) != (b < 0) && a != b) kept.emplace_back(p + (q - p) * (a / (a - b)));
  }
  return kept.size() < 3 ? 0 : area_of(kept);
}

/// By how much both anchors can be on their own side of a line that cuts off the first one's share:
/// the best of 720 directions [m]; negative when none can.
inline double best_line_for_two(const Polygon& area, const std::vector<Vector2>& anchors,
                                const std::vector<double>& shares) {
  const double wanted = shares[0] / (shares[0] + shares[1]) * area_of(area);
  double best = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < 720; ++k) {
    const double angle = k * std::numbers::pi / 360;
    const Vector2 up(std::cos(angle), std::sin(angle));
    double low = -1e4, high = 1e4;
    for (int i = 0; i < 60; ++i)
      (area_under(area, up, (low + high) / 2) < wanted ? low : high) = (low + high) / 2;
    best = std::max(best, std::min(low - up.dot(anchors[0]), up.dot(anchors[1]) - low));
  }
  return best;
}

}  // namespace skein::refiners::division
