// SPDX-License-Identifier: Apache-2.0
#include "skein/world/horizon.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace skein::world {
namespace {

TerrainSpec hilly() {
  TerrainSpec spec;
  spec.west = -400;
  spec.south = -300;
  spec.east = 607;
  spec.north = 500;
  spec.base = 5;
  spec.hills = {{{100, 100}, 60, 150}, {{300, -50}, 40, 120}, {{-100, 200}, -20, 100}};
  return spec;
}

TEST(HorizonProfile, OverLevelGroundIsThatOfTheGroundFarAway) {
  TerrainSpec spec = hilly();
  spec.hills.clear();
  const HorizonProfile horizon(Terrain(spec), {0, 0, 15}, 0.3, 200);

  EXPECT_NEAR(horizon.slope_until(100), -0.1, 1e-12);
  EXPECT_NEAR(horizon.slope_until(200), -0.05, 1e-12);
  EXPECT_TRUE(horizon.sees(100, 5 + 1e-9));
  EXPECT_FALSE(horizon.sees(100, 5 - 1e-6)) << "in the ground";
}

TEST(HorizonProfile, NothingIsHiddenBeyondItsReachOrTheTerrain) {
  const Terrain terrain(hilly());
  const HorizonProfile short_one(terrain, {-390, 100, 6}, 0, 100);
  const HorizonProfile outside(terrain, {700, 0, 6}, 0, 1000);

  EXPECT_TRUE(short_one.sees(900, 6)) << "the hill is beyond the reach";
  EXPECT_EQ(outside.slope_until(500), -std::numeric_limits<double>::infinity());
}

TEST(HorizonProfile, AHillHidesWhatIsBehindItAndNotWhatIsBeforeIt) {
  const HorizonProfile horizon(Terrain(hilly()), {-200, 100, 6}, 0, 800);

  EXPECT_TRUE(horizon.sees(100, 6));
  EXPECT_FALSE(horizon.sees(600, 60));
  EXPECT_TRUE(horizon.sees(600, 150));
}

RC_GTEST_PROP(HorizonProfile, AgreesWithTheLineOfSight, ()) {
  const auto within = [](int low, int high) { return *rc::gen::inRange(low, high) * 0.1; };
  const Terrain terrain(hilly());
  const double x = within(-4500, 6500), y = within(-3500, 5500);
  const Vector3 from(x, y, terrain.elevation(x, y) + within(0, 300) + 0.01);
  const double azimuth = *rc::gen::inRange(-314, 315) * 0.01, distance = within(1, 9000);
  const HorizonProfile horizon(terrain, from, azimuth, 900);

  const Vector2 at = from.head<2>() + distance * Vector2(std::cos(azimuth), std::sin(azimuth));
  const Vector3 to(at.x(), at.y(), terrain.elevation(at.x(), at.y()) + within(-50, 1500));

  // Within a micrometre of grazing either answer is right.
  if (horizon.sees(distance, to.z() - 1e-6))
    RC_ASSERT(terrain.line_of_sight(from, to + Vector3(0, 0, 1e-6)));
  if (!horizon.sees(distance, to.z() + 1e-6)) RC_ASSERT(!terrain.line_of_sight(from, to));
}

RC_GTEST_PROP(HorizonProfile, NeverFallsWithDistance, ()) {
  const Terrain terrain(hilly());
  const HorizonProfile horizon(terrain, {-50, 40, 30}, *rc::gen::inRange(-314, 315) * 0.01, 700);
  const double near = *rc::gen::inRange(1, 7000) * 0.1, more = *rc::gen::inRange(0, 1000) * 0.1;

  RC_ASSERT(horizon.slope_until(near) <= horizon.slope_until(near + more));
}

}  // namespace
}  // namespace skein::world
