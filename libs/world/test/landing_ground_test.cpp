// SPDX-License-Identifier: Apache-2.0
#include "skein/world/landing_ground.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace skein::world {
namespace {

/// Level but for a hill whose flanks, some 100 m around its top, are too steep.
Terrain hill(double cell = 20) {
  TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.cell = cell;
  spec.hills = {{{100, 0}, 80, 200}};
  return Terrain(spec);
}

double tangent(double slope) { return std::tan(slope); }

TEST(LandingGround, LevelGroundServesAndASlopeDoesNot) {
  EXPECT_FALSE(landing_problem(hill(), {-400, -400}));

  const auto problem = landing_problem(hill(), {10, 0});

  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("too steep to land"), std::string::npos);
}

TEST(LandingGround, NothingLandsOutsideTheTerrain) {
  EXPECT_EQ(landing_problem(hill(), {501, 0}), "no landing outside the terrain");
  EXPECT_EQ(landing_problem(hill(), {490, 0}, 30), "no landing outside the terrain");
}

TEST(LandingGround, AGentlePlaceBesideASteepOneDoesNotServeWhoMayMissIt) {
  const Terrain terrain = hill();
  ASSERT_FALSE(landing_problem(terrain, {100, 0})) << "the top is level";

  EXPECT_TRUE(landing_problem(terrain, {100, 0}, 80));
}

TEST(LandingGround, ABorderOfSteepGroundIsSeenByWhoMayMissItBarelyInLargeCells) {
  const Terrain terrain = hill(100);
  int borders = 0;
  for (double x = -300; x < 300; ++x) {
    if (landing_problem(terrain, {x, 10}) || !landing_problem(terrain, {x + 2, 10})) continue;
    ++borders;
    EXPECT_TRUE(landing_problem(terrain, {x, 10}, 2)) << x;
  }
  EXPECT_GT(borders, 0);
}

RC_GTEST_PROP(LandingGround, WhereADiskServesEveryPointOfItDoesButForWhatLiesBetweenItsPoints, ()) {
  const Terrain terrain = hill();
  const auto part = [](int least, int most) { return *rc::gen::inRange(least, most); };
  const Vector2 centre(part(-400, 400), part(-400, 400));
  const double radius = part(1, 60), angle = part(0, 360) * std::acos(-1.0) / 180;
  const double out = radius * part(0, 101) / 100;
  const Vector2 at = centre + out * Vector2(std::cos(angle), std::sin(angle));

  const bool serves = !landing_problem(terrain, centre, radius);
  RC_CLASSIFY(serves, "serves");

  if (serves) RC_ASSERT(tangent(terrain.slope(at.x(), at.y())) < 1.3 * tangent(kSteepestLanding));
  if (landing_problem(terrain, centre)) RC_ASSERT(!serves);
}

}  // namespace
}  // namespace skein::world
