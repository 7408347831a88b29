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

}  // namespace
}  // namespace skein::world
