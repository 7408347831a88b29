// SPDX-License-Identifier: Apache-2.0
#include "skein/sampling/collision_scene.hpp"

#include <gtest/gtest.h>

#include "worlds.hpp"

namespace skein::sampling {
namespace {

using world::Vector3;

/// Where the answer hangs on rounding, it is not asked [m].
constexpr double kBand = 1e-3;

world::World plain_with(std::vector<world::Volume> volumes) {
  world::World world = a_plain();
  world.volumes = std::move(volumes);
  return world;
}

Vector3 random_point(Random& random) {
  return {random.uniform(0, 1000), random.uniform(0, 1000), random.uniform(15, 200)};
}

/// The least distance from a segment to any of the volumes, by golden sections between samples: the
/// distance to a convex piece is convex along it, and pieces are wider than the samples are apart.
double least_distance(const std::vector<world::Volume>& volumes, const Vector3& a,
                      const Vector3& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& point : points_along({a, b}, 0.05))
    for (const world::Volume& volume : volumes) least = std::min(least, distance_to(volume, point));
  return least;
}

TEST(CollisionScene, ABallMeetsAVolumeExactlyWhereItIsNearer) {
  Random random(1);
  std::size_t hits = 0;
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<world::Volume> volumes;
    for (int i = 0; i < 12; ++i) volumes.push_back(a_star(random, std::to_string(i)));
    const CollisionScene sut(plain_with(volumes), {});
    for (int i = 0; i < 2'000; ++i) {
      const Vector3 point = random_point(random);
      const double radius = random.uniform(0.5, 14);
      const double distance = least_distance(volumes, point, point);
      if (std::abs(distance - radius) < kBand) continue;

      const bool collides = sut.collides(point, radius);

      ASSERT_EQ(collides, distance < radius) << point.transpose() << " " << radius;
      hits += collides;
    }
  }
  EXPECT_GT(hits, 2'000U);
}

TEST(CollisionScene, ASweptBallMeetsAVolumeExactlyWhereTheSegmentIsNearer) {
  Random random(2);
  std::size_t hits = 0;
  for (int scene = 0; scene < 10; ++scene) {
    std::vector<world::Volume> volumes;
    for (int i = 0; i < 6; ++i) volumes.push_back(a_star(random, std::to_string(i)));
    const CollisionScene sut(plain_with(volumes), {});
    for (int i = 0; i < 60; ++i) {
      const Vector3 a = random_point(random);
      const Vector3 b = a + 60 * Vector3(random.normal(), random.normal(), random.normal());
      if ((b.array() < 15).any() || (b.array() > Vector3(1000, 1000, 200).array()).any()) continue;
      const double radius = random.uniform(0.5, 5);
      const double distance = least_distance(volumes, a, b);
      if (std::abs(distance - radius) < 0.03) continue;  // the oracle samples every 5 cm

      const bool collides = sut.collides(a, b, radius);

      ASSERT_EQ(collides, distance < radius) << a.transpose() << " to " << b.transpose();
      hits += collides;
    }
  }
  EXPECT_GT(hits, 20U);
}

TEST(CollisionScene, TheGroundIsMetWhereTheTerrainSays) {
  Random random(3);
  for (int scene = 0; scene < 5; ++scene) {
    const world::World world = hills(random);
    const CollisionScene sut(world, {.clearance = 8});
    for (int i = 0; i < 2'000; ++i) {
      const Vector3 point = random_point(random);
      const double height = point.z() - world.terrain.elevation(point.x(), point.y());

      // The triangles are up to 0.25 m above the ground, and the ground may be steep beside a ball.
      if (sut.collides(point, 1)) {
        ASSERT_LT(height, 8.25 + 5);
      } else {
        ASSERT_GE(height, 8);
      }
      if (height > 8.3) {
        ASSERT_FALSE(sut.collides(point, 0));
      }
    }
  }
}

TEST(CollisionScene, ASegmentMeetsTheGroundWhereTheTerrainHasNoLineOfSight) {
  Random random(4);
  std::size_t hits = 0;
  for (int scene = 0; scene < 5; ++scene) {
    const world::World world = hills(random);
    const CollisionScene sut(world, {});
    for (int i = 0; i < 400; ++i) {
      const Vector3 a = random_point(random), b = random_point(random);
      const bool sight = world.terrain.line_of_sight(a, b, 0);
      const bool clear_sight = world.terrain.line_of_sight(a, b, 0.3);
      if (sight != clear_sight) continue;

      ASSERT_EQ(sut.collides(a, b, 0), !sight) << a.transpose() << " to " << b.transpose();
      hits += !sight;
    }
  }
  EXPECT_GT(hits, 300U);
}

TEST(CollisionScene, TheUndergroundIsNotFreeThoughNoSurfaceIsTouched) {
  world::World world = a_plain();
  world.airspace.origin.z() = -100;
  const CollisionScene sut(world, {});

  EXPECT_TRUE(sut.collides({500, 500, -60}, 1));
  EXPECT_TRUE(sut.collides({100, 500, -60}, {900, 500, -60}, 1));
}

TEST(CollisionScene, TheBayOfAConcaveVolumeIsFree) {
  world::Volume bay;
  bay.name = "bay";
  bay.polygon = {{300, 300}, {700, 300}, {700, 700}, {600, 700},
                 {600, 400}, {400, 400}, {400, 700}, {300, 700}};
  const CollisionScene sut(plain_with({bay}), {});

  EXPECT_FALSE(sut.collides({500, 900, 50}, {500, 410, 50}, 5));
  EXPECT_TRUE(sut.collides({500, 900, 50}, {500, 404, 50}, 5));
  EXPECT_TRUE(sut.collides({200, 600, 50}, {800, 600, 50}, 5));
  EXPECT_TRUE(sut.collides({350, 600, 50}, 1));
}

TEST(CollisionScene, VolumesCountOnlyInTheirTime) {
  world::Volume volume = a_box("drill", {400, 400}, {600, 600}, 0, 200);
  volume.when = {MissionTime::seconds(100), MissionTime::seconds(200)};
  const world::World world = plain_with({volume});
  const auto at = [](double from, double until) {
    return SceneSpec{.when = {MissionTime::seconds(from), MissionTime::seconds(until)}};
  };

  EXPECT_FALSE(CollisionScene(world, at(0, 100)).collides({500, 500, 50}, 1));
  EXPECT_TRUE(CollisionScene(world, at(0, 101)).collides({500, 500, 50}, 1));
  EXPECT_FALSE(CollisionScene(world, at(200, 300)).collides({500, 500, 50}, 1));
}

TEST(CollisionScene, NamesWhatIsMetFirstAndWhere) {
  const world::World world = plain_with(
      {a_box("far", {800, 0}, {900, 1000}, 0, 200), a_box("near", {400, 0}, {500, 1000}, 0, 200)});
  const CollisionScene sut(world, {.reserved = {a_box("other's", {100, 500}, {200, 600}, 0, 90)}});

  const auto conflict = sut.first_conflict({0, 50, 50}, {1000, 50, 50}, 10);
  const auto reserved = sut.first_conflict({150, 550, 80}, 1);

  ASSERT_TRUE(conflict.has_value());
  EXPECT_EQ(conflict->with, "the volume 'near'");
  EXPECT_NEAR(conflict->along, 0.39, 2e-4);
  EXPECT_EQ(reserved->with, "the volume 'other's'");
  EXPECT_EQ(reserved->along, 0);
  EXPECT_EQ(sut.first_conflict({0, 50, 50}, {0, 50, 0.5}, 1)->with, "the ground");
  EXPECT_EQ(sut.first_conflict({50, 50, 50}, {50, 50, 250}, 1)->with, "the limits of the airspace");
  EXPECT_FALSE(sut.first_conflict({0, 50, 50}, {380, 50, 50}, 10).has_value());
}

TEST(CollisionScene, ManyTrianglesAreBounded) {
  world::TerrainSpec spec;
  spec.east = spec.north = 1000;
  spec.cell = 1;
  Random random(5);
  for (int i = 0; i < 1001 * 1001; ++i) spec.elevations.push_back(random.uniform(0, 5));
  world::World world = a_plain();
  world.terrain = world::Terrain(spec);

  const CollisionScene sut(world, {});

  EXPECT_LE(sut.ground_triangles(), kMostTriangles);
  EXPECT_FALSE(sut.collides({100, 100, 7}, {900, 900, 7}, 1));
  EXPECT_TRUE(sut.collides({100, 100, 2}, {900, 900, 2}, 1));
}

TEST(CollisionScene, ClearanceIsHeightOnASteepSlopeToo) {
  world::World world = a_plain();
  world::TerrainSpec terrain = world.terrain.spec();
  terrain.hills = {{{500, 500}, 180, 150}};
  world.terrain = world::Terrain(terrain);
  const CollisionScene scene(world, {.clearance = 5, .ground_accuracy = 0.02});
  const auto over = [&](double height) {
    return Vector3(430, 500, world.terrain.elevation(430, 500) + height);
  };

  ASSERT_GT(world.terrain.slope(430, 500), 0.9);
  EXPECT_FALSE(scene.collides(over(5.05), 2)) << "the ball is 3 m off the ground itself";
  EXPECT_TRUE(scene.collides(over(4.95), 2));
  EXPECT_TRUE(scene.collides(over(5.05), 4.5)) << "the ball touches the flank";
}

}  // namespace
}  // namespace skein::sampling
