// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_detour.hpp"

#include <gtest/gtest.h>

#include "coverage/checks.hpp"
#include "testing/coverage_cases.hpp"

namespace skein::refiners {
namespace {

using testing::rectangle;
using world::Vector2;
using world::Vector3;

Obstacles obstacles_of(const std::vector<world::Polygon>& outlines) {
  Obstacles obstacles;
  obstacles.outlines = outlines;
  obstacles.is_free = [outlines](const Vector2& a, const Vector2& b) {
    return std::none_of(outlines.begin(), outlines.end(), [&](const world::Polygon& outline) {
      world::Volume volume;
      volume.polygon = outline;
      return enters(Vector3(a.x(), a.y(), 0), Vector3(b.x(), b.y(), 0), volume);
    });
  };
  return obstacles;
}

double length_of(const std::vector<Vector2>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

TEST(WayAround, IsStraightWhereThatIsFree) {
  const auto way = way_around(obstacles_of({rectangle(0, 0, 10, 10)}), {-5, 20}, {15, 20}, 1);

  ASSERT_TRUE(way);
  EXPECT_EQ(way->size(), 2U);
}

TEST(WayAround, PassesTheNearSideOfABoxAtItsMargin) {
  const auto way = way_around(obstacles_of({rectangle(0, -30, 10, 10)}), {-20, 0}, {30, 0}, 2);

  ASSERT_TRUE(way);
  EXPECT_EQ(way->front(), Vector2(-20, 0));
  EXPECT_EQ(way->back(), Vector2(30, 0));
  const double least = 2 * std::hypot(20, 10) + 10;
  EXPECT_GE(length_of(*way), least);
  EXPECT_LE(length_of(*way), least + 6);
}

TEST(WayAround, NeverEntersAnythingAmongManyBoxes) {
  Random random(51);

  for (int i = 0; i < 50; ++i) {
    std::vector<world::Polygon> boxes;
    for (int k = 0; k < 12; ++k) {
      const double x = random.uniform(-200, 180), y = random.uniform(-200, 180);
      boxes.push_back(rectangle(x, y, x + random.uniform(5, 40), y + random.uniform(5, 40)));
    }
    const Obstacles obstacles = obstacles_of(boxes);
    const auto way = way_around(obstacles, {-300, 0}, {300, 0}, 1);
    ASSERT_TRUE(way);
    for (std::size_t k = 1; k < way->size(); ++k)
      ASSERT_TRUE(obstacles.is_free((*way)[k - 1], (*way)[k]));
  }
}

TEST(WayAround, GivesNothingWhereAllAroundIsClosed) {
  EXPECT_FALSE(way_around(obstacles_of({rectangle(-10, -10, 10, 10)}), {0, 0}, {30, 0}, 1));
}

}  // namespace
}  // namespace skein::refiners
