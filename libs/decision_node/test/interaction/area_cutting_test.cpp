// SPDX-License-Identifier: Apache-2.0
#include "interaction/area_cutting.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <numbers>

#include "skein/foundation/random.hpp"
#include "skein/world/segment.hpp"

namespace skein::decision_node {
namespace {

using world::Polygon;
using world::Vector2;

const Polygon kSquare = {{0, 0}, {200, 0}, {200, 200}, {0, 200}};

TEST(Between, KeepsWhatLiesBetweenTwoLines) {
  const Polygon strip = between(kSquare, Vector2::UnitX(), 50, 80);

  EXPECT_NEAR(world::area(strip), 30 * 200, 1e-9);
  for (const Vector2& corner : strip) {
    EXPECT_GE(corner.x(), 50 - 1e-9);
    EXPECT_LE(corner.x(), 80 + 1e-9);
  }
  EXPECT_NEAR(world::area(between(kSquare, Vector2::UnitX(), -10, 500)), 40000, 1e-9);
  EXPECT_LT(world::area(between(kSquare, Vector2::UnitX(), 300, 400)), 1e-9);
}

double sum_of(const std::vector<Polygon>& areas) {
  double sum = 0;
  for (const Polygon& one : areas) sum += world::area(one);
  return sum;
}

TEST(CutOut, OfACornerLeavesWhatLiesBesideIt) {
  std::vector<Polygon> areas{kSquare}, within;
  cut_out({{150, 150}, {300, 150}, {300, 300}, {150, 300}}, 10, areas, within);

  EXPECT_NEAR(sum_of(within), 60 * 60, 1e-6);
  EXPECT_NEAR(sum_of(areas), 200 * 200 - 60 * 60, 1e-6);
}

TEST(CutOut, WhatLiesElsewhereCutsNothing) {
  std::vector<Polygon> areas{kSquare}, within;
  cut_out({{350, 150}, {400, 150}, {400, 300}, {350, 300}}, 10, areas, within);

  EXPECT_TRUE(within.empty());
  EXPECT_NEAR(sum_of(areas), 200 * 200, 1e-6);
}

TEST(CutOut, OneThatIsNotConvexCountsAsItsBox) {
  std::vector<Polygon> areas{kSquare}, within;
  cut_out({{50, 50}, {150, 50}, {150, 150}, {140, 60}}, 0, areas, within);

  EXPECT_NEAR(sum_of(within), 100 * 100, 1e-6);
}

Polygon convex_around(Random& random, double x, double y, double radius) {
  Polygon polygon;
  const std::size_t corners = 3 + random.below(5);
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = (static_cast<double>(i) + random.uniform(0, 0.9)) * 2 * std::numbers::pi /
                         static_cast<double>(corners);
    polygon.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  if (random.chance(0.5)) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

RC_GTEST_PROP(CutOutLaw, NothingIsLostOrCountedTwiceAndNothingBesideComesNearerThanTheMargin,
              (std::uint32_t seed)) {
  Random random(seed, "areas");
  const double margin = random.uniform(0, 40);
  const Polygon hole =
      convex_around(random, random.uniform(-300, 300), random.uniform(-300, 300), 120);
  const Polygon area = convex_around(random, 0, 0, random.uniform(50, 400));
  std::vector<Polygon> beside{area}, within;
  cut_out(hole, margin, beside, within);

  const double slivers = kNoArea * static_cast<double>(hole.size() + 1);
  RC_ASSERT(sum_of(beside) + sum_of(within) <= world::area(area) + 1e-6);
  RC_ASSERT(sum_of(beside) + sum_of(within) >= world::area(area) - slivers - 1e-6);
  for (const Polygon& one : beside) {
    RC_ASSERT(common_area(one, hole) < 1e-6);
    for (const Vector2& corner : one) RC_ASSERT(world::to_polygon(corner, hole) >= margin - 1e-6);
  }
}

}  // namespace
}  // namespace skein::decision_node
