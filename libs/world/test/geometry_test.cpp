// SPDX-License-Identifier: Apache-2.0
#include "skein/world/geometry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "skein/world/wind.hpp"

namespace skein::world {
namespace {

constexpr double kPi = std::numbers::pi;
const Polygon kSquare = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
const Polygon kArrow = {{0, 0}, {10, 5}, {0, 10}, {4, 5}};  // not convex

TEST(Wrapped, StaysWithinOneTurn) {
  EXPECT_NEAR(wrapped(3 * kPi), kPi, 1e-12);
  EXPECT_NEAR(wrapped(-kPi), kPi, 1e-12) << "the end that belongs to the range";
  EXPECT_NEAR(wrapped(kPi + 0.1), -kPi + 0.1, 1e-12);
  EXPECT_EQ(wrapped(1), 1);
}

RC_GTEST_PROP(Wrapped, IsTheSameDirection, (int thousandths)) {
  const double angle = thousandths * 1e-3;
  const double result = wrapped(angle);

  RC_ASSERT(result > -kPi - 1e-12);
  RC_ASSERT(result <= kPi + 1e-12);
  RC_ASSERT(std::abs(std::sin(result) - std::sin(angle)) < 1e-6);
  RC_ASSERT(std::abs(std::cos(result) - std::cos(angle)) < 1e-6);
}

TEST(DirectionOf, FollowsTheConventionOfTheFrame) {
  EXPECT_NEAR((direction_of(0, 0) - Vector3(1, 0, 0)).norm(), 0, 1e-12) << "east";
  EXPECT_NEAR((direction_of(kPi / 2, 0) - Vector3(0, 1, 0)).norm(), 0, 1e-12) << "north";
  EXPECT_NEAR((direction_of(1, -kPi / 2) - Vector3(0, 0, -1)).norm(), 0, 1e-12) << "down";
}

TEST(MeanVelocity, BlowsToward) {
  EXPECT_NEAR((mean_velocity({kPi / 2, 3, 1}) - Vector3(0, 3, 0)).norm(), 0, 1e-12);
}

TEST(Contains, InsideOutsideAndOnTheEdge) {
  EXPECT_TRUE(contains(kSquare, {5, 5}));
  EXPECT_TRUE(contains(kSquare, {10, 5}));
  EXPECT_TRUE(contains(kSquare, {0, 0}));
  EXPECT_FALSE(contains(kSquare, {10.01, 5}));
  EXPECT_FALSE(contains(kArrow, {2, 5})) << "in the notch";
  EXPECT_TRUE(contains(kArrow, {5, 5}));
  EXPECT_FALSE(contains({}, {0, 0}));
}

TEST(Contains, ARepeatedCornerIsNoEdgeThroughEverything) {
  EXPECT_FALSE(contains({{0, 0}, {0, 0}, {5, 0}, {5, 5}}, {100, 100}));
  EXPECT_TRUE(contains({{0, 0}, {0, 0}, {5, 0}, {5, 5}}, {0, 0}));
}

TEST(Contains, AVertexLevelWithThePointCountsOnce) {
  const Polygon diamond = {{5, 0}, {10, 5}, {5, 10}, {0, 5}};
  EXPECT_TRUE(contains(diamond, {5, 5}));
  EXPECT_FALSE(contains(diamond, {-1, 5}));
  EXPECT_FALSE(contains(diamond, {11, 5}));
}

/// Independent oracle: the sum of the angles under which the edges are seen is a whole turn or
/// none.
double winding(const Polygon& polygon, const Vector2& p) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(sum) / (2 * kPi);
}

RC_GTEST_PROP(Contains, AgreesWithTheWindingNumber, ()) {
  // Odd thousandths: never on an edge of the arrow.
  const auto coordinate =
      rc::gen::map(rc::gen::inRange(-1000, 6000), [](int n) { return (2 * n + 1) * 1e-3 + 1e-5; });
  const Vector2 p(*coordinate, *coordinate);

  RC_ASSERT(contains(kArrow, p) == (winding(kArrow, p) > 0.5));
}

TEST(Area, DoesNotDependOnTheSense) {
  Polygon reversed(kArrow.rbegin(), kArrow.rend());
  EXPECT_EQ(area(kSquare), 100);
  EXPECT_EQ(area(kArrow), area(reversed));
  EXPECT_EQ(area({{0, 0}, {1, 1}}), 0);
}

}  // namespace
}  // namespace skein::world
