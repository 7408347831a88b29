// SPDX-License-Identifier: Apache-2.0
#include "skein/world/polygon_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "skein/foundation/random.hpp"

namespace skein::world {
namespace {

TEST(PolygonRings, TheLastCornerOfAClosedRingIsTheFirstAgain) {
  const Polygon open = {{0, 0}, {10, 0}, {10, 10}};
  Polygon closed = open;
  closed.push_back(open.front());

  EXPECT_EQ(without_closing_corner(closed), open);
  EXPECT_EQ(without_closing_corner(open), open);
  EXPECT_EQ(without_closing_corner({}), Polygon{});
}

/// A coast: large and small bays.
Polygon coast(std::size_t corners, std::uint64_t seed) {
  Random random(seed);
  const double phase = random.uniform(0, 6);
  Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double far = 1000 + 200 * std::sin(5 * angle + phase) + 30 * std::sin(61 * angle) +
                       random.uniform(-1, 1);
    polygon.emplace_back(far * std::cos(angle), far * std::sin(angle));
  }
  return polygon;
}

double distance_to_border(const Polygon& polygon, const Vector2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2 edge = polygon[(i + 1) % polygon.size()] - a;
    const double part = std::clamp(edge.dot(point - a) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + part * edge - point).norm());
  }
  return least;
}

double farthest_corner(const Polygon& of, const Polygon& from) {
  double most = 0;
  for (const Vector2& corner : of) most = std::max(most, distance_to_border(from, corner));
  return most;
}

TEST(PolygonRings, WhatIsLeftOfManyCornersIsSimpleAndAsNearAsItSays) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const std::size_t most : {2000UL, 300UL, 40UL}) {
      const Polygon polygon = coast(6000, seed);

      const auto kept = simplified(polygon, most);

      ASSERT_TRUE(kept);
      EXPECT_LE(kept->polygon.size(), most);
      EXPECT_GT(kept->polygon.size(), most / 3);
      EXPECT_EQ(problem_of(kept->polygon), std::nullopt);
      EXPECT_GT(kept->tolerance, 0);
      EXPECT_LE(farthest_corner(polygon, kept->polygon), kept->tolerance + 1e-9);
      EXPECT_LE(farthest_corner(kept->polygon, polygon), kept->tolerance + 1e-9);
      EXPECT_NEAR(area(kept->polygon), area(polygon), kept->tolerance * 8000);
    }
}

TEST(PolygonRings, FewCornersStayAsTheyAre) {
  const Polygon polygon = coast(500, 1);

  const auto kept = simplified(polygon, 500);

  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->polygon, polygon);
  EXPECT_EQ(kept->tolerance, 0);
}

TEST(PolygonRings, CornersThatDoNotMatterAreLeftOutForNothing) {
  Polygon square;
  for (int i = 0; i < 1000; ++i) square.emplace_back(i, 0);
  for (int i = 0; i < 1000; ++i) square.emplace_back(1000, i);
  for (int i = 0; i < 1000; ++i) square.emplace_back(1000 - i, 1000);
  for (int i = 0; i < 1000; ++i) square.emplace_back(0, 1000 - i);

  const auto kept = simplified(square, 100);

  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->polygon, (Polygon{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}));
  EXPECT_EQ(kept->tolerance, 0);
}

TEST(PolygonRings, ABowTieStaysABowTieHoweverManyCornersAreLeftOut) {
  Polygon tie;
  for (int i = 0; i < 1000; ++i) tie.emplace_back(i, i);
  for (int i = 0; i < 1000; ++i) tie.emplace_back(1000, 1000 - i);
  for (int i = 0; i < 1000; ++i) tie.emplace_back(1000 - i, i);
  for (int i = 0; i < 1000; ++i) tie.emplace_back(0, 1000 - i);

  EXPECT_FALSE(simplified(tie, 2000));
}

}  // namespace
}  // namespace skein::world
