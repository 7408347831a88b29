// SPDX-License-Identifier: Apache-2.0
#include "skein/world/segment.hpp"

#include <gtest/gtest.h>

namespace skein::world {
namespace {

TEST(ToSegment, IsToTheNearestPointOfItNotOfItsLine) {
  EXPECT_DOUBLE_EQ(to_segment(Vector2(5, 3), Vector2(0, 0), Vector2(10, 0)), 3);
  EXPECT_DOUBLE_EQ(to_segment(Vector2(-3, 4), Vector2(0, 0), Vector2(10, 0)), 5);
  EXPECT_DOUBLE_EQ(to_segment(Vector3(13, 0, 4), Vector3(0, 0, 0), Vector3(10, 0, 0)), 5);
}

TEST(ToSegment, OfAPointIsToThat) {
  EXPECT_DOUBLE_EQ(to_segment(Vector2(3, 4), Vector2(0, 0), Vector2(0, 0)), 5);
}

TEST(ToPolygon, IsToItsBorderFromOutsideAndNothingInside) {
  const Polygon square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(to_polygon({5, 5}, square), 0);
  EXPECT_DOUBLE_EQ(to_polygon({5, 13}, square), 3);
  EXPECT_DOUBLE_EQ(to_polygon({-3, -4}, square), 5);
}

TEST(BetweenSegments, IsNothingWhereTheyCrossOrTouch) {
  EXPECT_EQ(between_segments({-9, 0}, {9, 0}, {0, -9}, {0, 9}), 0);
  EXPECT_EQ(between_segments({-9, 0}, {9, 0}, {4, 0}, {4, 9}), 0);
}

TEST(BetweenSegments, IsFromAnEndToTheOtherWhereTheyDoNot) {
  EXPECT_DOUBLE_EQ(between_segments({0, 0}, {10, 0}, {5, 2}, {5, 9}), 2);
  EXPECT_DOUBLE_EQ(between_segments({0, 0}, {10, 0}, {3, 4}, {30, 4}), 4);
  EXPECT_DOUBLE_EQ(between_segments({0, 0}, {0, 0}, {3, 4}, {3, 4}), 5);
}

}  // namespace
}  // namespace skein::world
