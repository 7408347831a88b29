// SPDX-License-Identifier: Apache-2.0
#include "ground_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "worlds.hpp"

namespace skein::sampling {
namespace {

constexpr Region kAll{-40, -40, 1040, 1040};

/// Measured ground as rough as it gets: every corner of a cell anyhow.
world::Terrain rough(Random& random, double steep) {
  world::TerrainSpec spec;
  spec.east = 1000;
  spec.north = 990;  // the last row is only half as deep
  const std::size_t columns = 50, rows = 50;
  for (std::size_t i = 0; i < (columns + 1) * (rows + 1); ++i)
    spec.elevations.push_back(random.uniform(0, steep));
  return world::Terrain(spec);
}

void expect_just_above(const GroundMesh& mesh, const world::Terrain& terrain, double accuracy,
                       Random& random) {
  for (int i = 0; i < 20'000; ++i) {
    const double x = random.uniform(-30, 1030), y = random.uniform(-30, 1030);
    const double above = mesh.height(x, y) - terrain.elevation(x, y);
    ASSERT_GE(above, -1e-9) << x << " " << y;
    ASSERT_LE(above, accuracy + 1e-9) << x << " " << y;
  }
}

TEST(GroundMesh, IsNeverBelowTheGroundAndAboveItByTheAccuracyAtMost) {
  Random random(1);
  for (const double accuracy : {0.05, 0.25, 2.0}) {
    const auto terrain = rough(random, 15);

    const GroundMesh mesh(terrain, kAll, accuracy, 4'000'000);

    expect_just_above(mesh, terrain, accuracy, random);
  }
}

TEST(GroundMesh, ItsTrianglesAreWhatItsHeightSays) {
  Random random(2);
  const GroundMesh mesh(rough(random, 10), kAll, 0.5, 1'000'000);

  for (std::size_t i = 0; i < mesh.triangles().size(); i += 7) {
    const auto& [a, b, c] = mesh.triangles()[i];
    const world::Vector3 middle =
        0.2 * mesh.vertices()[a] + 0.3 * mesh.vertices()[b] + 0.5 * mesh.vertices()[c];
    ASSERT_NEAR(mesh.height(middle.x(), middle.y()), middle.z(), 1e-9);
  }
}

TEST(GroundMesh, LevelGroundNeedsTwoTrianglesPerCell) {
  world::TerrainSpec spec;
  spec.east = spec.north = 100;

  const GroundMesh mesh(world::Terrain(spec), {0, 0, 100, 100}, 0.1, 1000);

  EXPECT_EQ(mesh.triangles().size(), 50U);
  EXPECT_EQ(mesh.highest(), 0);
}

TEST(GroundMesh, LessensItsAccuracyRatherThanTakeTooManyTriangles) {
  Random random(3);
  const auto terrain = rough(random, 40);

  const GroundMesh mesh(terrain, kAll, 0.01, 20'000);

  EXPECT_LE(mesh.triangles().size(), 20'000U);
  expect_just_above(mesh, terrain, 40, random);
}

TEST(GroundMesh, MergesCellsOfWhichThereAreTooManyAndStaysAbove) {
  Random random(4);
  const auto terrain = rough(random, 40);

  const GroundMesh mesh(terrain, kAll, 0.25, 500);

  EXPECT_LE(mesh.triangles().size(), 500U);
  expect_just_above(mesh, terrain, 40, random);
}

TEST(GroundMesh, ARegionWithinACellOrBesideTheTerrainIsCoveredToo) {
  Random random(5);
  const auto terrain = rough(random, 10);
  for (const Region& region :
       {Region{503, 503, 507, 508}, Region{-500, 200, -100, 300}, Region{1200, 1200, 1300, 1400}}) {
    const GroundMesh mesh(terrain, region, 0.1, 1000);

    for (int i = 0; i < 100; ++i) {
      const double x = random.uniform(region.west, region.east);
      const double y = random.uniform(region.south, region.north);
      const double above = mesh.height(x, y) - terrain.elevation(x, y);
      EXPECT_GE(above, -1e-9);
      EXPECT_LE(above, 0.1);
    }
  }
}

}  // namespace
}  // namespace skein::sampling
