// SPDX-License-Identifier: Apache-2.0
// Terrain from measured elevations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "skein/world/terrain.hpp"

namespace skein::world {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// 4 × 3 corners, each with its number.
TerrainSpec numbered() {
  TerrainSpec spec{-30, 10, 60, 70, 30, 5, {}, {}};
  for (int i = 0; i < 12; ++i) spec.elevations.push_back(i);
  return spec;
}

/// A rough ground of any shape.
TerrainSpec rough() {
  TerrainSpec spec;
  spec.cell = *rc::gen::inRange(3, 40);
  spec.west = *rc::gen::inRange(-500, 500);
  spec.south = *rc::gen::inRange(-500, 500);
  spec.east = spec.west + *rc::gen::inRange(5, 600);
  spec.north = spec.south + *rc::gen::inRange(5, 600);
  const auto heights = *rc::gen::container<std::vector<int>>(corners_of(spec).count(),
                                                             rc::gen::inRange(-1000, 4000));
  for (const int height : heights) spec.elevations.push_back(height * 0.01);
  return spec;
}

Vector3 over(const Terrain& terrain) {
  const TerrainSpec& spec = terrain.spec();
  const double x = spec.west + (spec.east - spec.west) * (*rc::gen::inRange(0, 1001) / 1000.0);
  const double y = spec.south + (spec.north - spec.south) * (*rc::gen::inRange(0, 1001) / 1000.0);
  return {x, y, terrain.elevation(x, y) + *rc::gen::inRange(1, 3000) * 0.01};
}

TEST(MeasuredTerrain, RowsGoFromSouthToNorthAndColumnsFromWestToEast) {
  const Terrain terrain(numbered());

  EXPECT_EQ(terrain.elevation(-30, 10), 0) << "south-west";
  EXPECT_EQ(terrain.elevation(60, 10), 3) << "south-east";
  EXPECT_EQ(terrain.elevation(-30, 70), 8) << "north-west";
  EXPECT_EQ(terrain.elevation(60, 70), 11) << "north-east";
  EXPECT_EQ(terrain.elevation(0, 40), 5);
  EXPECT_NEAR(terrain.elevation(15, 25), (1 + 2 + 5 + 6) / 4.0, 1e-12) << "bilinear between";
  EXPECT_EQ(terrain.corner(2, 1), 6);
  EXPECT_EQ(terrain.lowest(), 0);
  EXPECT_EQ(terrain.highest(), 11);
}

TEST(MeasuredTerrain, HillsAddUpOnIt) {
  TerrainSpec spec = numbered();
  spec.hills = {{{0, 40}, 100, 20}, {{0, 40}, 10, 20}};

  const Terrain terrain(spec);

  EXPECT_NEAR(terrain.elevation(0, 40), 115, 1e-9);
  EXPECT_EQ(terrain.elevation(-30, 10), 0) << "beyond the hills";
}

TEST(MeasuredTerrain, ItsElevationsAreHeldOnce) {
  TerrainSpec spec = numbered();
  const double* given = spec.elevations.data();

  const Terrain terrain(std::move(spec));

  EXPECT_THAT(terrain.spec().elevations, IsEmpty());
  EXPECT_EQ(terrain.spec().cell, 30);
  EXPECT_EQ(given[5], terrain.corner(1, 1)) << "moved, not copied: the same memory";
}

TEST(MeasuredTerrain, AWrongNumberOfElevationsIsAProblem) {
  TerrainSpec spec = numbered();
  spec.elevations.pop_back();

  EXPECT_THAT(problems_of(spec), ElementsAre("terrain: 11 elevations for 4 × 3 corners"));
}

TEST(MeasuredTerrain, ElevationsThatAreNoGroundAreAProblem) {
  for (const double wrong : {kNaN, std::numeric_limits<double>::infinity(), -1e9, 1e5 + 1}) {
    TerrainSpec spec = numbered();
    spec.elevations[6] = wrong;

    EXPECT_THAT(problems_of(spec), ElementsAre(HasSubstr("elevation 7 is not between"))) << wrong;
  }
}

TEST(MeasuredTerrain, AWrongExtentIsSaidWithoutCountingElevations) {
  TerrainSpec spec = numbered();
  spec.cell = kNaN;

  EXPECT_THAT(problems_of(spec), ElementsAre("terrain: the cell must be greater than 0",
                                             "terrain: every figure must be finite"));
}

TEST(MeasuredTerrain, MoreHillsThanCanBeWorkedThroughAreAProblem) {
  TerrainSpec spec = numbered();
  spec.hills.assign(kMostHills + 1, {{0, 0}, 1, 1});

  EXPECT_THAT(problems_of(spec), ElementsAre("terrain: more than 1000 hills"));
}

TEST(MeasuredTerrain, NothingIsSeenFromNowhere) {
  const Terrain terrain(numbered());
  const Vector3 nowhere(kNaN, 0, 100), far(1e308, 0, 100), seen(0, 20, 100);

  EXPECT_FALSE(terrain.line_of_sight(nowhere, seen));
  EXPECT_FALSE(terrain.line_of_sight(seen, nowhere));
  EXPECT_FALSE(terrain.line_of_sight(far, Vector3(-1e308, 0, 0))) << "too far to be told";
  EXPECT_FALSE(terrain.line_of_sight({0, 20, kNaN}, {0, 30, kNaN}));
  EXPECT_TRUE(std::isnan(terrain.elevation(kNaN, 0)));
}

RC_GTEST_PROP(MeasuredTerrain, IsAtItsCornersWhatWasGiven, ()) {
  const TerrainSpec spec = rough();
  const Terrain terrain(spec);
  const TerrainCorners corners = corners_of(spec);

  for (std::size_t row = 0; row < corners.rows; ++row)
    for (std::size_t column = 0; column < corners.columns; ++column) {
      const double given = spec.elevations[row * corners.columns + column];
      const double x = spec.west + static_cast<double>(column) * spec.cell;
      const double y = spec.south + static_cast<double>(row) * spec.cell;
      RC_ASSERT(terrain.corner(column, row) == given);
      if (terrain.contains(x, y)) RC_ASSERT(std::abs(terrain.elevation(x, y) - given) < 1e-9);
    }
}

RC_GTEST_PROP(MeasuredTerrain, SightAgreesWithFineSamplingAndIsSymmetrical, ()) {
  const Terrain terrain(rough());
  const Vector3 a = over(terrain), b = over(terrain);

  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 20000; ++i) {
    const Vector3 p = a + (i / 20000.0) * (b - a);
    least = std::min(least, p.z() - terrain.elevation(p.x(), p.y()));
  }

  const bool seen = terrain.line_of_sight(a, b);
  RC_ASSERT(seen == terrain.line_of_sight(b, a));
  if (std::abs(least) > 1e-3) RC_ASSERT(seen == (least > 0));
}

RC_GTEST_PROP(MeasuredTerrain, AHillAddsWhatItsFormulaSays, ()) {
  TerrainSpec spec = rough();
  const Terrain bare(spec);
  const HillSpec hill{{*rc::gen::inRange(-600, 1200) * 1.0, *rc::gen::inRange(-600, 1200) * 1.0},
                      *rc::gen::inRange(-100, 100) * 1.0,
                      *rc::gen::inRange(1, 900) * 1.0};
  spec.hills = {hill};
  const Terrain raised(spec);
  const TerrainCorners corners = corners_of(spec);

  for (std::size_t row = 0; row < corners.rows; ++row)
    for (std::size_t column = 0; column < corners.columns; ++column) {
      const Vector2 at(spec.west + static_cast<double>(column) * spec.cell,
                       spec.south + static_cast<double>(row) * spec.cell);
      const double d = (at - hill.at).norm();
      const double expected =
          d < hill.radius ? hill.height * (1 + std::cos(std::numbers::pi * d / hill.radius)) / 2
                          : 0;
      RC_ASSERT(std::abs(raised.corner(column, row) - bare.corner(column, row) - expected) < 1e-9);
    }
}

}  // namespace
}  // namespace skein::world
