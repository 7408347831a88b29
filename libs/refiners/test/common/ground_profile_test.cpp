// SPDX-License-Identifier: Apache-2.0
#include "common/ground_profile.hpp"

#include <gtest/gtest.h>

#include "testing/raw_ground.hpp"

namespace skein::refiners {
namespace {

using testing::Relief;
using world::Vector2;

TEST(GroundProfile, NoGroundStandsOutOfItAndItIsExactOnTheLinesOfTheGrid) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto rough = testing::rough_world(Relief::kRaster, seed, 300);
    Random random(seed, "legs");
    const Vector2 from(random.uniform(-1000, 1000), random.uniform(-1000, 1000));
    const Vector2 to(random.uniform(-1000, 1000), random.uniform(-1000, 1000));
    const auto profile = ground_along(rough.world.terrain, from, to);
    ASSERT_EQ(profile.front().part, 0);
    ASSERT_EQ(profile.back().part, 1);
    double above = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
      ASSERT_GT(profile[i].part, profile[i - 1].part);
      for (double k = 0; k <= 1; k += 0.125) {
        const double part = profile[i - 1].part + k * (profile[i].part - profile[i - 1].part);
        const double z = profile[i - 1].ground + k * (profile[i].ground - profile[i - 1].ground);
        const Vector2 at = from + part * (to - from);
        const double ground = rough.raw.at(at.x(), at.y());
        EXPECT_GE(z, ground - 1e-6);
        above = std::max(above, z - ground);
      }
    }
    EXPECT_LT(above, 4) << "metres that it may be above ground as rough as this";
    for (const double part : grid_crossings(rough.world.terrain, from, to)) {
      const auto point = std::find_if(profile.begin(), profile.end(),
                                      [&](const auto& p) { return p.part == part; });
      if (point == profile.end()) continue;
      const Vector2 at = from + part * (to - from);
      EXPECT_NEAR(point->ground, rough.raw.at(at.x(), at.y()), 1e-6);
    }
  }
}

TEST(GroundProfile, OfLevelGroundIsItsEnds) {
  const auto world = testing::level_world();
  EXPECT_TRUE(is_level(world.terrain));
  EXPECT_EQ(ground_along(world.terrain, {0, 0}, {500, 300}).size(), 2U);
}

TEST(GroundProfile, RastersAreNotLevelGround) {
  EXPECT_FALSE(is_level(testing::rough_world(Relief::kRaster, 1, 40).world.terrain));
}

}  // namespace
}  // namespace skein::refiners
