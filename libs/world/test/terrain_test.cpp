// SPDX-License-Identifier: Apache-2.0
#include "skein/world/terrain.hpp"

#include <gmock/gmock.h>
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
  spec.east = 600;
  spec.north = 500;
  spec.cell = 20;
  spec.base = 5;
  spec.hills = {{{100, 100}, 60, 150}, {{300, -50}, 40, 120}, {{-100, 200}, -20, 100}};
  return spec;
}

TerrainSpec level() {
  TerrainSpec spec = hilly();
  spec.hills.clear();
  return spec;
}

TEST(Terrain, StandsOnItsBaseAndItsHillsAddUp) {
  const Terrain terrain(hilly());

  EXPECT_EQ(terrain.elevation(-390, -290), 5);
  EXPECT_NEAR(terrain.elevation(100, 100), 65, 1e-9) << "a top on a node of the grid";
  EXPECT_NEAR(terrain.elevation(-100, 200), -15, 1e-9) << "a hollow";
  EXPECT_NEAR(terrain.highest(), 65, 1e-9);
}

TEST(Terrain, IsBilinearWithinACell) {
  const Terrain terrain(hilly());
  const double sw = terrain.elevation(120, 140), se = terrain.elevation(140, 140);
  const double nw = terrain.elevation(120, 160), ne = terrain.elevation(140, 160);

  EXPECT_NEAR(terrain.elevation(130, 150), (sw + se + nw + ne) / 4, 1e-9);
  EXPECT_NEAR(terrain.elevation(125, 140), 0.75 * sw + 0.25 * se, 1e-9);
}

TEST(Terrain, GoesOnAsItsBorderOutside) {
  const Terrain terrain(hilly());

  EXPECT_EQ(terrain.elevation(9000, 100), terrain.elevation(600, 100));
  EXPECT_EQ(terrain.elevation(-9000, -9000), terrain.elevation(-400, -300));
}

TEST(Terrain, ContainsItsExtentWithItsBorder) {
  const Terrain terrain(hilly());

  EXPECT_TRUE(terrain.contains(-400, -300));
  EXPECT_TRUE(terrain.contains(600, 500));
  EXPECT_FALSE(terrain.contains(600.1, 0));
  EXPECT_FALSE(terrain.contains(0, -300.1));
}

TEST(Terrain, AnExtentThatIsNoMultipleOfTheCellIsCovered) {
  TerrainSpec spec = hilly();
  spec.east = 607;
  const Terrain terrain(spec);

  EXPECT_TRUE(terrain.contains(606, 0));
  EXPECT_TRUE(std::isfinite(terrain.elevation(607, 500)));
}

RC_GTEST_PROP(Terrain, IsContinuous, ()) {
  const Terrain terrain(hilly());
  const double x = *rc::gen::inRange(-4200, 6200) * 0.1, y = *rc::gen::inRange(-3200, 5200) * 0.1;

  RC_ASSERT(std::abs(terrain.elevation(x, y) - terrain.elevation(x + 1e-6, y - 1e-6)) < 1e-4);
}

RC_GTEST_PROP(Terrain, SlopeIsThatOfTheSurface, ()) {
  const Terrain terrain(hilly());
  // Off the grid lines, where there is one slope only.
  const double x = *rc::gen::inRange(-39, 59) * 10 + 3.3, y = *rc::gen::inRange(-29, 49) * 10 + 4.4;
  const double h = 1e-4;
  const double dx = (terrain.elevation(x + h, y) - terrain.elevation(x - h, y)) / (2 * h);
  const double dy = (terrain.elevation(x, y + h) - terrain.elevation(x, y - h)) / (2 * h);

  RC_ASSERT(std::abs(std::tan(terrain.slope(x, y)) - std::hypot(dx, dy)) < 1e-5);
}

TEST(Terrain, LevelGroundHidesNothingNotEvenFromItself) {
  const Terrain terrain(level());

  EXPECT_TRUE(terrain.line_of_sight({-300, 0, 5}, {500, 400, 5}));
  EXPECT_TRUE(terrain.line_of_sight({0, 0, 5}, {0, 0, 5}));
  EXPECT_FALSE(terrain.line_of_sight({0, 0, 4.9}, {100, 0, 5}));
}

TEST(Terrain, AHillHidesWhatIsBehindIt) {
  const Terrain terrain(hilly());

  EXPECT_FALSE(terrain.line_of_sight({-100, 100, 10}, {350, 150, 10}));
  EXPECT_TRUE(terrain.line_of_sight({-100, 100, 80}, {350, 150, 80}));
  EXPECT_TRUE(terrain.line_of_sight({-350, -250, 6}, {-350, 450, 6}));
}

TEST(Terrain, ClearanceIsKeptAboveTheGround) {
  const Terrain terrain(level());

  EXPECT_TRUE(terrain.line_of_sight({0, 0, 15}, {100, 0, 15}, 10));
  EXPECT_FALSE(terrain.line_of_sight({0, 0, 14.9}, {100, 0, 15}, 10));
  EXPECT_TRUE(terrain.line_of_sight({0, 0, 3}, {100, 0, 3}, -3)) << "negative: may graze";
}

TEST(Terrain, OutsideItsExtentNothingHides) {
  const Terrain terrain(level());

  EXPECT_TRUE(terrain.line_of_sight({700, 0, -100}, {900, 0, -100}));
  EXPECT_FALSE(terrain.line_of_sight({500, 0, -100}, {900, 0, -100})) << "one end inside";
  EXPECT_FALSE(terrain.line_of_sight({-900, 0, -100}, {900, 0, -100})) << "passes through";
}

TEST(Terrain, AVerticalLineIsSeenUntilTheGround) {
  const Terrain terrain(hilly());

  EXPECT_TRUE(terrain.line_of_sight({100, 100, 200}, {100, 100, 65.01}));
  const auto hit = terrain.first_hit({100, 100, 165}, {100, 100, -35});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(*hit, 0.5, 1e-6);
}

RC_GTEST_PROP(Terrain, TheFirstHitIsOnTheGroundAndNothingIsBefore, ()) {
  const Terrain terrain(hilly());
  const auto end = [] {
    return Vector3(*rc::gen::inRange(-450, 650), *rc::gen::inRange(-350, 550),
                   *rc::gen::inRange(0, 100));
  };
  const Vector3 a = end(), b = end();

  const auto hit = terrain.first_hit(a, b);

  const auto gap = [&](double t) {
    const Vector3 p = a + t * (b - a);
    const bool inside = p.x() >= -400 && p.x() <= 600 && p.y() >= -300 && p.y() <= 500;
    return inside ? p.z() - terrain.elevation(p.x(), p.y()) : 1e9;
  };
  if (hit) {
    RC_ASSERT(*hit >= 0);
    RC_ASSERT(*hit <= 1);
    RC_ASSERT(gap(*hit) < 1e-4);
  }
  // The independent oracle: many samples of the line, none of them under the ground before the hit.
  for (int i = 0; i <= 4000; ++i) {
    const double t = i / 4000.0;
    if (t < hit.value_or(2) - 1e-9) RC_ASSERT(gap(t) > -1e-6);
  }
}

RC_GTEST_PROP(Terrain, LineOfSightAgreesWithFineSamplingAndIsSymmetrical, ()) {
  const Terrain terrain(hilly());
  const auto end = [&] {
    const double x = *rc::gen::inRange(-390, 590), y = *rc::gen::inRange(-290, 490);
    return Vector3(x, y, terrain.elevation(x, y) + *rc::gen::inRange(1, 50));
  };
  const Vector3 a = end(), b = end();

  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 20000; ++i) {
    const Vector3 p = a + (i / 20000.0) * (b - a);
    least = std::min(least, p.z() - terrain.elevation(p.x(), p.y()));
  }

  const bool seen = terrain.line_of_sight(a, b);
  RC_ASSERT(seen == terrain.line_of_sight(b, a));
  if (std::abs(least) > 1e-3) RC_ASSERT(seen == (least > 0));
}

TEST(TerrainSpec, EveryProblemIsGivenAtOnce) {
  TerrainSpec spec;
  spec.hills = {{{0, 0}, 10, 0}, {{0, 0}, std::nan(""), 5}};
  spec.cell = -1;

  EXPECT_THAT(problems_of(spec),
              testing::ElementsAre("terrain: east must be greater than west",
                                   "terrain: north must be greater than south",
                                   "terrain: the cell must be greater than 0",
                                   "terrain: hill 1: the radius must be greater than 0",
                                   "terrain: hill 2: every figure must be finite"));
  EXPECT_TRUE(problems_of(hilly()).empty());
}

TEST(TerrainSpec, AGridThatWouldNotFitInMemoryIsAProblem) {
  TerrainSpec spec = hilly();
  spec.cell = 0.01;

  EXPECT_THAT(problems_of(spec),
              testing::ElementsAre("terrain: more than 4 million cells; use a larger cell"));
}

TEST(TerrainDeathTest, AProblemIsABrokenContract) {
  EXPECT_DEATH(Terrain(TerrainSpec{}), "precondition");
}

}  // namespace
}  // namespace skein::world
