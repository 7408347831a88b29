// SPDX-License-Identifier: Apache-2.0
#include "skein/world/crossing.hpp"

#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"

namespace skein::world {
namespace {

const Volume kBox{"box", {{0, 0}, {100, 0}, {100, 100}, {0, 100}}, 20, 60, {}};

TEST(Crossing, IsThroughASideOrFromAbove) {
  EXPECT_TRUE(crosses(kBox, 0, Vector3(-50, 50, 40), Vector3(150, 50, 40)));
  EXPECT_TRUE(crosses(kBox, 0, Vector3(50, 50, 100), Vector3(50, 50, 50)));
  EXPECT_TRUE(crosses(kBox, 0, Vector3(50, 50, 40), Vector3(51, 50, 40)));
}

TEST(Crossing, IsNotAboveBelowOrBeside) {
  EXPECT_FALSE(crosses(kBox, 0, Vector3(-50, 50, 61), Vector3(150, 50, 61)));
  EXPECT_FALSE(crosses(kBox, 0, Vector3(-50, 50, 19), Vector3(150, 50, 19)));
  EXPECT_FALSE(crosses(kBox, 0, Vector3(-50, -1, 40), Vector3(150, -1, 40)));
  EXPECT_FALSE(crosses(kBox, 0, Vector3(-60, 50, 100), Vector3(40, 50, 61)));
}

TEST(Crossing, CountsTheMargin) {
  EXPECT_TRUE(crosses(kBox, 2, Vector3(-50, -1, 40), Vector3(150, -1, 40)));
  EXPECT_TRUE(crosses(kBox, 2, Vector3(50, 50, 61), Vector3(60, 50, 61)));
  EXPECT_FALSE(crosses(kBox, 0.5, Vector3(-50, -1, 40), Vector3(150, -1, 40)));
}

TEST(Crossing, OfTheRestOfAWayForgetsWhatWasFlown) {
  const std::vector<Vector3> way{{-50, 50, 40}, {150, 50, 40}, {150, 300, 40}};

  EXPECT_TRUE(crosses(kBox, 0, rest_of(way, Vector3(-10, 52, 40))));
  EXPECT_FALSE(crosses(kBox, 0, rest_of(way, Vector3(120, 49, 40))));
  EXPECT_EQ(rest_of(way, Vector3(150, 200, 40)).size(), 2U);
}

// Against points along the segment.
RC_GTEST_PROP(Crossing, AgreesWithSamples, (std::uint64_t seed)) {
  Random random(seed);
  const auto point = [&] {
    return Vector3(random.uniform(-150, 250), random.uniform(-150, 250), random.uniform(0, 90));
  };
  const Vector3 a = point(), b = point();
  bool inside = false;
  for (int i = 0; i <= 400; ++i) {
    const Vector3 p = a + (b - a) * (i / 400.0);
    inside = inside || (contains(kBox.polygon, p.head<2>()) && p.z() >= 20 && p.z() <= 60);
  }

  if (inside) RC_ASSERT(crosses(kBox, 0, a, b));
  if (!inside) RC_ASSERT(!crosses({"", {{2, 2}, {98, 2}, {98, 98}, {2, 98}}, 22, 58, {}}, 0, a, b));
}

}  // namespace
}  // namespace skein::world
