// SPDX-License-Identifier: Apache-2.0
#include "shortcuts.hpp"

#include <gtest/gtest.h>

#include "worlds.hpp"

namespace skein::sampling {
namespace {

using refiners::Way;
using world::Vector3;

const auto kNever = [] { return false; };

Way zigzag(Random& random) {
  Way way;
  for (int i = 0; i < 30; ++i)
    way.emplace_back(10 * i, random.uniform(-50, 50), random.uniform(20, 80));
  return way;
}

TEST(Shortened, IsStraightWhereEverythingIsFree) {
  Random random(1);
  const Way way = zigzag(random);

  const Way best = shortened(
      way, [](const Vector3&, const Vector3&) { return true; }, kNever, random);

  EXPECT_EQ(best, (Way{way.front(), way.back()}));
}

TEST(Shortened, NeverUsesALegThatIsNotFreeAndIsNeverLonger) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Way way = zigzag(random);
    // Only what stays within 60 m of the axis x and rises less than 40 m is free, or as it was.
    const auto is_free = [&](const Vector3& a, const Vector3& b) {
      for (std::size_t k = 1; k < way.size(); ++k)
        if (a == way[k - 1] && b == way[k]) return true;
      return (b - a).norm() < 60 && std::abs(b.z() - a.z()) < 40;
    };

    const Way best = shortened(way, is_free, kNever, random);

    EXPECT_EQ(best.front(), way.front());
    EXPECT_EQ(best.back(), way.back());
    EXPECT_LE(refiners::length_of(best), refiners::length_of(way) + 1e-9);
    EXPECT_LT(refiners::length_of(best), 0.6 * refiners::length_of(way));
  }
}

TEST(Shortened, LeavesAWayOfTwoPointsAlone) {
  Random random(3);
  const Way way = {{0, 0, 0}, {1, 1, 1}};

  EXPECT_EQ(shortened(
                way, [](const Vector3&, const Vector3&) { return false; }, kNever, random),
            way);
}

}  // namespace
}  // namespace skein::sampling
