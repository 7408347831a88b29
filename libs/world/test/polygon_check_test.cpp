// SPDX-License-Identifier: Apache-2.0
#include "skein/world/polygon_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace skein::world {
namespace {

using ::testing::HasSubstr;

std::string problem(const Polygon& polygon) { return problem_of(polygon).value_or(""); }

/// A star: corners at growing angles round a middle, at any distance; never crosses itself.
Polygon star() {
  const int corners = *rc::gen::inRange(3, 30);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + *rc::gen::inRange(0, 80) / 100.0) / corners;
    const double distance = *rc::gen::inRange(100, 1000);
    polygon.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
  }
  return polygon;
}

TEST(PolygonCheck, SimplePolygonsOfEitherSenseArePolygons) {
  EXPECT_EQ(problem({{0, 0}, {10, 0}, {10, 10}}), "");
  EXPECT_EQ(problem({{0, 0}, {10, 10}, {10, 0}}), "");
  EXPECT_EQ(problem({{0, 0}, {10, 0}, {10, 10}, {5, 2}, {0, 10}}), "") << "with a dent";
  EXPECT_EQ(problem({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}), "") << "a straight corner";
}

TEST(PolygonCheck, FewerThanThreeCornersAreNone) {
  EXPECT_THAT(problem({}), HasSubstr("0 corners"));
  EXPECT_THAT(problem({{0, 0}, {10, 0}}), HasSubstr("2 corners"));
}

TEST(PolygonCheck, ABowTieCrossesItself) {
  EXPECT_EQ(problem({{0, 0}, {10, 10}, {10, 0}, {0, 10}}),
            "the edges after corner 1 and corner 3 cross or touch");
}

TEST(PolygonCheck, TouchingItselfIsNotSimpleEither) {
  EXPECT_THAT(problem({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}), HasSubstr("cross or touch"));
  EXPECT_THAT(problem({{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}, {5, 5}}),
              HasSubstr("cross or touch"))
      << "at a corner";
}

TEST(PolygonCheck, RepeatedCornersSpikesAndLinesAreRefused) {
  EXPECT_THAT(problem({{0, 0}, {10, 0}, {10, 0}, {10, 10}}),
              HasSubstr("corner 2 and corner 3 are the same place"));
  EXPECT_THAT(problem({{0, 0}, {10, 0}, {10, 10}, {0, 0}}),
              HasSubstr("corner 4 and corner 1 are the same place"))
      << "closed by repeating the first";
  EXPECT_THAT(problem({{0, 0}, {10, 0}, {10, 10}, {10, 20}, {10, 5}}), HasSubstr("folds back"));
  EXPECT_THAT(problem({{0, 0}, {10, 0}, {20, 0}}), HasSubstr("folds back")) << "a line";
}

TEST(PolygonCheck, CornersThatAreNoNumbersAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_THAT(problem({{0, 0}, {10, nan}, {10, 10}}), HasSubstr("corner 2 is not two finite"));
  EXPECT_THAT(problem({{0, 0}, {10, 0}, {10, std::numeric_limits<double>::infinity()}}),
              HasSubstr("corner 3"));
}

TEST(PolygonCheck, MoreCornersThanCanBeCheckedAreRefused) {
  Polygon circle;
  for (std::size_t i = 0; i <= kMostCorners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / (kMostCorners + 1.0);
    circle.emplace_back(1e4 * std::cos(angle), 1e4 * std::sin(angle));
  }

  EXPECT_THAT(problem(circle), HasSubstr("2001 corners: at most 2000"));
  circle.pop_back();
  EXPECT_EQ(problem(circle), "");
}

RC_GTEST_PROP(PolygonCheck, AStarIsSimple, ()) { RC_ASSERT(problem(star()).empty()); }

RC_GTEST_PROP(PolygonCheck, NeitherTheFirstCornerNorTheSenseCounts, ()) {
  Polygon polygon;
  const int corners = *rc::gen::inRange(3, 8);
  for (int i = 0; i < corners; ++i)
    polygon.emplace_back(*rc::gen::inRange(0, 6), *rc::gen::inRange(0, 6));
  const bool simple = !problem_of(polygon);

  std::rotate(polygon.begin(), polygon.begin() + *rc::gen::inRange(0, corners), polygon.end());
  RC_ASSERT(simple == !problem_of(polygon));
  std::reverse(polygon.begin(), polygon.end());
  RC_ASSERT(simple == !problem_of(polygon));
}

/// The independent oracle: on a lattice of small integers, whether two segments share a point is
/// decided in whole numbers.
struct Lattice {
  static long side(const Vector2& a, const Vector2& b, const Vector2& p) {
    const auto whole = [](double x) { return std::lround(x); };
    return (whole(b.x()) - whole(a.x())) * (whole(p.y()) - whole(a.y())) -
           (whole(b.y()) - whole(a.y())) * (whole(p.x()) - whole(a.x()));
  }
  static bool on(const Vector2& a, const Vector2& b, const Vector2& p) {
    return side(a, b, p) == 0 && (p - a).dot(p - b) <= 0;
  }
  static bool meet(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
    const auto sign = [](long x) { return (x > 0) - (x < 0); };
    if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return true;
    return sign(side(a, b, c)) * sign(side(a, b, d)) < 0 &&
           sign(side(c, d, a)) * sign(side(c, d, b)) < 0;
  }
  static bool simple(const Polygon& p) {
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (p[i] == p[(i + 1) % n]) return false;
      if (on(p[i], p[(i + 1) % n], p[(i + 2) % n]) || on(p[(i + 1) % n], p[(i + 2) % n], p[i]))
        return false;
      for (std::size_t j = i + 2; j < n; ++j)
        if ((j + 1) % n != i && meet(p[i], p[i + 1], p[j], p[(j + 1) % n])) return false;
    }
    return true;
  }
};

RC_GTEST_PROP(PolygonCheck, AgreesWithWholeNumbers, ()) {
  Polygon polygon;
  const int corners = *rc::gen::inRange(3, 8);
  for (int i = 0; i < corners; ++i)
    polygon.emplace_back(*rc::gen::inRange(-6, 6), *rc::gen::inRange(-6, 6));

  RC_ASSERT(Lattice::simple(polygon) == !problem_of(polygon));
}

}  // namespace
}  // namespace skein::world
