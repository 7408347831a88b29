// SPDX-License-Identifier: Apache-2.0
#include "skein/world/ground_normal.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace skein::world {
namespace {

Terrain with_hills() {
  TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.hills = {{{0, 0}, 80, 300}, {{-200, 150}, -40, 200}};
  return Terrain(spec);
}

/// Rises by `east` and `north` for each metre that way.
Terrain plane(double east, double north) {
  TerrainSpec spec;
  spec.east = spec.north = 100;
  spec.cell = 10;
  for (int row = 0; row <= 10; ++row)
    for (int column = 0; column <= 10; ++column)
      spec.elevations.push_back(10 * (east * column + north * row));
  return Terrain(spec);
}

TEST(GroundNormal, IsStraightUpOnLevelGround) {
  TerrainSpec spec;
  spec.east = spec.north = 100;

  EXPECT_EQ(ground_normal(Terrain(spec), 40, 60), Vector3(0, 0, 1));
}

TEST(GroundNormal, IsThatOfAPlaneAnywhereInIt) {
  const Terrain ground = plane(0.5, -0.25);
  const Vector3 normal = Vector3(-0.5, 0.25, 1).normalized();

  EXPECT_LT((ground_normal(ground, 50, 50) - normal).norm(), 1e-12) << "on a corner";
  EXPECT_LT((ground_normal(ground, 43.21, 67.8) - normal).norm(), 1e-12);
}

TEST(GroundNormal, IsStraightUpFarOffTheTerrain) {
  EXPECT_EQ(ground_normal(with_hills(), 5000, -7000), Vector3(0, 0, 1));
}

TEST(GroundNormal, FacesAwayFromTheTopOfAHill) {
  const Terrain ground = with_hills();

  EXPECT_GT(ground_normal(ground, 150, 0).x(), 0.1);
  EXPECT_LT(ground_normal(ground, 0, -150).y(), -0.1);
}

RC_GTEST_PROP(GroundNormal, IsAUnitVectorUpwardsThatDoesNotJump, ()) {
  static const Terrain ground = with_hills();
  const double x = *rc::gen::inRange(-5200, 5200) * 0.1, y = *rc::gen::inRange(-5200, 5200) * 0.1;

  const Vector3 normal = ground_normal(ground, x, y);

  RC_ASSERT(std::abs(normal.norm() - 1) < 1e-12);
  RC_ASSERT(normal.z() > 0);
  RC_ASSERT((normal - ground_normal(ground, x + 1e-6, y - 1e-6)).norm() < 1e-5);
}

}  // namespace
}  // namespace skein::world
