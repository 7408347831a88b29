// SPDX-License-Identifier: Apache-2.0
#include "skein/world/airspace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "skein/foundation/random.hpp"

namespace skein::world {
namespace {

AirspaceGrid grid_of(std::int32_t x, std::int32_t y, std::int32_t z, double voxel = 10) {
  AirspaceGrid grid;
  grid.voxel = voxel;
  grid.size = {x, y, z};
  return grid;
}

/// Some voxels blocked, the others at various costs.
Airspace random_airspace(Random& random, const AirspaceGrid& grid, double blocked) {
  std::vector<std::uint8_t> voxels(grid.count());
  for (std::uint8_t& voxel : voxels)
    voxel = random.chance(blocked) ? Airspace::kBlocked
                                   : static_cast<std::uint8_t>(16 + random.below(33));
  return {grid, std::move(voxels)};
}

Vector3 point_in(Random& random, const AirspaceGrid& grid) {
  Vector3 point;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    // Now and then on a face, since that is where rules differ.
    const double along =
        random.chance(0.3)
            ? static_cast<double>(random.below(static_cast<std::uint64_t>(grid.size[i]) + 1))
            : random.uniform(0, grid.size[i]);
    point[k] = grid.origin[k] + along * grid.voxel;
  }
  return point;
}

double distance_to(const Polygon& polygon, const Vector2& point) {
  if (contains(polygon, point)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2 edge = polygon[(i + 1) % polygon.size()] - a;
    const double along = std::clamp(edge.dot(point - a) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + along * edge - point).norm());
  }
  return least;
}

/// A star: simple, mostly concave.
Polygon random_star(Random& random, const Vector2& centre, double radius) {
  Polygon polygon;
  const auto corners = 3 + random.below(7);
  for (std::uint64_t i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(corners);
    const double reach = random.uniform(0.2, 1) * radius;
    polygon.push_back(centre + reach * Vector2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

TerrainSpec level_at(double base) {
  TerrainSpec spec;
  spec.east = spec.north = 50;
  spec.base = base;
  return spec;
}

Terrain random_terrain(Random& random) {
  TerrainSpec spec;
  spec.west = random.uniform(-60, 30);
  spec.south = random.uniform(-60, 30);
  spec.east = spec.west + random.uniform(100, 250);
  spec.north = spec.south + random.uniform(100, 250);
  spec.cell = random.uniform(3, 30);
  for (int i = 0; i < 4; ++i)
    spec.hills.push_back({{random.uniform(0, 150), random.uniform(0, 150)},
                          random.uniform(-20, 60),
                          random.uniform(20, 80)});
  return Terrain(spec);
}

TEST(AirspaceGrid, IsRefusedWithSentencesWhenItMakesNoSense) {
  AirspaceGrid grid = grid_of(0, 5, 2'000'000);
  grid.voxel = std::numeric_limits<double>::quiet_NaN();
  grid.origin.x() = std::numeric_limits<double>::infinity();

  EXPECT_EQ(problems_of(grid).size(), 4U);
  EXPECT_EQ(problems_of(grid_of(1 << 15, 1 << 15, 2)).size(), 1U) << "too many in all";
  EXPECT_THAT(problems_of(grid_of(512, 512, 64)), testing::IsEmpty());
}

TEST(Airspace, IsFreeWithinItsGridOnly) {
  const Airspace airspace(grid_of(4, 3, 2));

  EXPECT_TRUE(airspace.is_free(3, 2, 1));
  EXPECT_FALSE(airspace.is_free(4, 2, 1));
  EXPECT_FALSE(airspace.is_free(0, -1, 0));
  EXPECT_TRUE(airspace.is_free(Vector3(40, 30, 20))) << "the border belongs to it";
  EXPECT_FALSE(airspace.is_free(Vector3(40.1, 30, 20)));
  EXPECT_FALSE(airspace.is_free(Vector3(std::nan(""), 1, 1)));
  EXPECT_FALSE(airspace.is_free(Vector3(1, 1, 1), Vector3(1, 1, 20.5)));
  EXPECT_FALSE(airspace.is_free(Vector3(1, 1, 1), Vector3(1, std::nan(""), 1)));
}

TEST(Airspace, FindsTheVoxelOfAPoint) {
  const Airspace airspace(grid_of(4, 3, 2));

  EXPECT_EQ(airspace.voxel_at({10, 9.9, 0}), (Voxel{1, 0, 0}));
  EXPECT_EQ(airspace.voxel_at({40, 30, 20}), (Voxel{3, 2, 1}));
  EXPECT_EQ(airspace.voxel_at({-0.1, 5, 5}), std::nullopt);
  EXPECT_EQ(airspace.centre({1, 0, 1}), Vector3(15, 5, 15));
}

TEST(Airspace, TakesAFreeNeighbourForAPointOnAFace) {
  Airspace airspace(grid_of(2, 1, 1));
  airspace.keep_where([](const Voxel& at) { return at[0] == 0; });

  EXPECT_EQ(airspace.voxel_at({10, 5, 5}), (Voxel{1, 0, 0}));
  EXPECT_EQ(airspace.free_voxel_at({10, 5, 5}), (Voxel{0, 0, 0}));
  EXPECT_EQ(airspace.free_voxel_at({10.1, 5, 5}), std::nullopt);
}

TEST(Airspace, LetsASegmentRunAlongAFaceWithOneSideFree) {
  Airspace airspace(grid_of(4, 2, 2));
  airspace.keep_where([](const Voxel& at) { return at[2] == 1; });

  EXPECT_TRUE(airspace.is_free(Vector3(1, 5, 10), Vector3(39, 5, 10)));
  EXPECT_TRUE(airspace.is_free(Vector3(1, 10, 10), Vector3(39, 10, 10))) << "an edge";
  EXPECT_TRUE(airspace.is_free(Vector3(1, 5, 10), Vector3(39, 15, 19)));
  EXPECT_FALSE(airspace.is_free(Vector3(1, 5, 10), Vector3(39, 15, 9)));
}

TEST(Airspace, LetsNothingBetweenTwoBlockedVoxelsThatTouch) {
  Airspace airspace(grid_of(2, 2, 1));
  airspace.keep_where([](const Voxel& at) { return at[0] == at[1]; });

  EXPECT_FALSE(airspace.is_free(Vector3(5, 5, 5), Vector3(15, 15, 5)));
  EXPECT_FALSE(airspace.is_free(Vector3(15, 15, 5), Vector3(5, 5, 5)));
  EXPECT_TRUE(airspace.is_free(Vector3(5, 5, 5), Vector3(10, 10, 5))) << "it may end there";
}

TEST(Airspace, LetsNothingPassAnEdgeOfABlockedVoxel) {
  Airspace airspace(grid_of(2, 2, 2));
  airspace.keep_where([](const Voxel& at) { return at != Voxel{1, 0, 0}; });

  EXPECT_FALSE(airspace.is_free(Vector3(5, 5, 5), Vector3(15, 15, 5)));
  EXPECT_FALSE(airspace.is_free(Vector3(5, 5, 5), Vector3(15, 15, 15))) << "a corner";
  EXPECT_TRUE(airspace.is_free(Vector3(5, 15, 5), Vector3(15, 15, 15)));
}

TEST(Airspace, SumsTheCrossingCostsAlongASegment) {
  Airspace airspace(grid_of(3, 1, 1));
  Volume dear;
  dear.polygon = {{12, 2}, {18, 2}, {18, 8}, {12, 8}};
  airspace.set_cost(dear, 2.5);

  EXPECT_DOUBLE_EQ(airspace.cost({0, 5, 5}, {30, 5, 5}).value(), 10 + 25 + 10);
  EXPECT_DOUBLE_EQ(airspace.cost({10, 2, 5}, {10, 8, 5}).value(), 6) << "the cheaper side";
  EXPECT_EQ(airspace.greatest_cost(), 40);
  EXPECT_EQ(airspace.least_cost(), 16);
}

TEST(Airspace, BlocksTheVoxelsThatAVolumeTouches) {
  Airspace airspace(grid_of(5, 5, 5));
  Volume zone;
  zone.polygon = {{20, 20}, {25, 20}, {25, 25}, {20, 25}};
  zone.floor = 12;
  zone.ceiling = 20;

  airspace.block(zone);

  EXPECT_FALSE(airspace.is_free(2, 2, 1));
  EXPECT_FALSE(airspace.is_free(1, 1, 2)) << "touching is enough";
  EXPECT_TRUE(airspace.is_free(3, 2, 1));
  EXPECT_TRUE(airspace.is_free(2, 2, 0));
  EXPECT_TRUE(airspace.is_free(2, 2, 3));
}

TEST(Airspace, TakesOnlyTheVolumesThatHoldThen) {
  const Terrain level(level_at(0));
  Volume zone;
  zone.polygon = {{20, 20}, {25, 20}, {25, 25}};
  zone.when = {MissionTime::seconds(100), MissionTime::seconds(200)};
  AirspaceSpec spec;
  spec.grid = grid_of(5, 5, 5);

  const auto free_during = [&](double from, double until) {
    spec.when = {MissionTime::seconds(from), MissionTime::seconds(until)};
    return Airspace(spec, level, {zone}).is_free(2, 2, 2);
  };

  EXPECT_TRUE(free_during(0, 100));
  EXPECT_FALSE(free_during(0, 101));
  EXPECT_FALSE(free_during(199, 300));
  EXPECT_TRUE(free_during(200, 300));
}

TEST(Airspace, StandsOnLevelGround) {
  const Terrain level(level_at(20));
  AirspaceSpec spec;
  spec.grid = grid_of(5, 5, 5);

  EXPECT_FALSE(Airspace(spec, level, {}).is_free(2, 2, 1));
  EXPECT_TRUE(Airspace(spec, level, {}).is_free(2, 2, 2)) << "it may touch the ground";
  spec.clearance = 0.1;
  EXPECT_FALSE(Airspace(spec, level, {}).is_free(2, 2, 2));
  EXPECT_TRUE(Airspace(spec, level, {}).is_free(2, 2, 3));
}

RC_GTEST_PROP(AirspaceProperty, HasNoPointOfAFreeVoxelNearTheGround, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Terrain terrain = random_terrain(random);
  AirspaceSpec spec;
  spec.grid = grid_of(14, 15, 9);
  spec.grid.origin = {random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 0)};
  spec.clearance = random.uniform(0, 15);
  const Airspace airspace(spec, terrain, {});

  for (int i = 0; i < 3000; ++i) {
    const Vector3 point = point_in(random, spec.grid);
    if (airspace.is_free(point))
      RC_ASSERT(point.z() - terrain.elevation(point.x(), point.y()) >= spec.clearance - 1e-8);
  }
}

TEST(Airspace, EndsAtTheCeilingOverTheLowestGround) {
  TerrainSpec ground = level_at(5);
  ground.hills = {{{45, 45}, 10, 9}};
  AirspaceSpec spec;
  spec.grid = grid_of(5, 5, 5);
  spec.ceiling = 35;

  const Airspace airspace(spec, Terrain(ground), {});

  EXPECT_TRUE(airspace.is_free(0, 0, 3));
  EXPECT_FALSE(airspace.is_free(0, 0, 4));
  EXPECT_FALSE(airspace.is_free(4, 4, 4)) << "the hill does not lift it: ground beside is lower";
}

/// Wide grids are made in parts.
TEST(Airspace, IsTheSameInAWideGridAsInAGridOfItsOwn) {
  Random random(5);
  TerrainSpec ground = level_at(5);
  ground.east = 150;
  ground.cell = 0.7;
  for (int i = 0; i < 20; ++i)
    ground.hills.push_back({{random.uniform(0, 150), random.uniform(40, 42)}, 0.15, 3});
  const Terrain terrain(ground);
  AirspaceSpec spec;
  spec.grid = grid_of(5000, 70, 16, 0.03);
  spec.grid.origin = {0, 40, 4.9};
  spec.clearance = 0.11;
  spec.body_radius = 0.02;
  spec.ceiling = 0.3;
  const Volume zone{"zone", {{0, 40.5}, {120, 40.2}, {135, 41.9}, {1, 41.8}}, -1e3, 1e3, {}};
  const Airspace wide(spec, terrain, {zone});

  std::size_t different = 0, free = 0;
  for (std::int32_t first = 0; first < 5000; first += 100) {
    AirspaceSpec part = spec;
    part.grid.origin.x() += first * spec.grid.voxel;
    part.grid.size[0] = 100;
    const Airspace narrow(part, terrain, {zone});
    for (std::int32_t z = 0; z < 16; ++z)
      for (std::int32_t y = 0; y < 70; ++y)
        for (std::int32_t x = 0; x < 100; ++x) {
          different += wide.is_free(first + x, y, z) != narrow.is_free(x, y, z) ? 1 : 0;
          free += narrow.is_free(x, y, z) ? 1 : 0;
        }
  }

  EXPECT_EQ(different, 0U);
  EXPECT_GT(free, 100'000U);
  EXPECT_LT(free, 2'700'000U);
}

TEST(Airspace, IsMadeBlockedKeptAndCopiedOnlyUntilTheTimeIsUp) {
  AirspaceSpec spec;
  spec.grid = grid_of(400, 400, 400);
  const Terrain level(level_at(20));
  const Volume all{"all", {{-1, -1}, {4001, -1}, {4001, 4001}, {-1, 4001}}, 0, 4000, {}};
  const auto never = [] { return false; };
  int asked = 0;
  const auto soon = [&] { return ++asked > 1; };

  auto made = Airspace::in_time(spec, level, {}, never);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->voxels(), Airspace(spec, level, {}).voxels());
  ASSERT_TRUE(made->copied(never));
  EXPECT_EQ(made->copied(never)->voxels(), made->voxels());

  EXPECT_FALSE(Airspace::in_time(spec, level, {}, soon));
  EXPECT_EQ(std::exchange(asked, 0), 2);
  EXPECT_TRUE(Airspace::in_time(spec, level, {all}, [&] { return ++asked < 0; }));
  const int last = std::exchange(asked, 0);
  EXPECT_GT(last, 3);
  EXPECT_FALSE(Airspace::in_time(spec, level, {all}, [&] { return ++asked >= last; }));
  EXPECT_EQ(std::exchange(asked, 0), last);
  EXPECT_FALSE(made->copied(soon));
  EXPECT_EQ(std::exchange(asked, 0), 2);
  EXPECT_FALSE(made->keep_where([](const Voxel&) { return true; }, soon));
  EXPECT_EQ(std::exchange(asked, 0), 2);
  EXPECT_FALSE(made->block(all, 0, soon));
  EXPECT_EQ(std::exchange(asked, 0), 2);
  EXPECT_TRUE(made->is_free(399, 399, 399)) << "the rest was not blocked any more";
  EXPECT_TRUE(made->block(all, 0, never));
  EXPECT_FALSE(made->is_free(399, 399, 399));
}

/// What takes some milliseconds is made whatever the clock says.
TEST(Airspace, OfFewVoxelsIsMadeEvenWhenTheTimeIsUp) {
  AirspaceSpec spec;
  spec.grid = grid_of(60, 60, 20);
  EXPECT_TRUE(Airspace::in_time(spec, Terrain(level_at(20)), {}, [] { return true; }));
}

RC_GTEST_PROP(AirspaceProperty, KeepsABodyOffTheGround, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Terrain terrain = random_terrain(random);
  AirspaceSpec spec;
  spec.grid = grid_of(14, 15, 9);
  spec.body_radius = random.uniform(0.1, 8);
  const Airspace airspace(spec, terrain, {});

  for (int i = 0; i < 1000; ++i) {
    const Vector3 point = point_in(random, spec.grid);
    if (!airspace.is_free(point)) continue;
    const double angle = random.uniform(0, 2 * M_PI), pitch = random.uniform(-M_PI / 2, 0);
    const Vector3 skin = point + spec.body_radius * direction_of(angle, pitch);
    RC_ASSERT(skin.z() - terrain.elevation(skin.x(), skin.y()) >= -1e-8);
  }
}

RC_GTEST_PROP(AirspaceProperty, BlocksNoVoxelWithoutGroundTooNear, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Terrain terrain = random_terrain(random);
  AirspaceSpec spec;
  spec.grid = grid_of(8, 8, 9);
  spec.clearance = random.uniform(0, 15);
  const Airspace airspace(spec, terrain, {});

  for (std::int32_t y = 0; y < 8; ++y)
    for (std::int32_t x = 0; x < 8; ++x) {
      double highest = -1e9, steepest = 0;
      for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j) {
          const Vector2 at(x * 10 + i * 0.25, y * 10 + j * 0.25);
          const double here = terrain.elevation(at.x(), at.y());
          highest = std::max(highest, here);
          steepest = std::max(steepest, std::tan(terrain.slope(at.x(), at.y())));
          // Beyond the raster's edge the ground is that of the edge, which rises along it.
          steepest =
              std::max(steepest, std::abs(terrain.elevation(at.x(), at.y() + 0.25) - here) / 0.25);
          steepest =
              std::max(steepest, std::abs(terrain.elevation(at.x() + 0.25, at.y()) - here) / 0.25);
        }
      for (std::int32_t z = 0; z < 9; ++z)
        if (!airspace.is_free(x, y, z))
          RC_ASSERT(highest + spec.clearance + steepest > z * 10.0 - 1e-9);
    }
}

RC_GTEST_PROP(AirspaceProperty, HasNoPointOfAFreeVoxelNearAVolume, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Airspace airspace(grid_of(12, 11, 6));
  Volume zone;
  zone.polygon =
      random_star(random, {random.uniform(0, 120), random.uniform(0, 110)}, random.uniform(2, 60));
  zone.floor = random.uniform(-20, 50);
  zone.ceiling = zone.floor + random.uniform(1, 30);
  const double margin = random.chance(0.5) ? 0 : random.uniform(0, 15);

  airspace.block(zone, margin);

  for (int i = 0; i < 2000; ++i) {
    const Vector3 point = point_in(random, airspace.grid());
    const bool beside = distance_to(zone.polygon, point.head<2>()) > margin;
    const bool below = point.z()<zone.floor - margin, above = point.z()> zone.ceiling + margin;
    if (airspace.is_free(point)) RC_ASSERT(beside || below || above);
  }
}

RC_GTEST_PROP(AirspaceProperty, BlocksNoVoxelFarFromEveryVolume, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Airspace airspace(grid_of(12, 11, 6));
  Volume zone;
  zone.polygon =
      random_star(random, {random.uniform(0, 120), random.uniform(0, 110)}, random.uniform(2, 60));
  zone.floor = random.uniform(-20, 50);
  zone.ceiling = zone.floor + random.uniform(1, 30);
  const double margin = random.chance(0.5) ? 0 : random.uniform(0, 15);

  airspace.block(zone, margin);

  for (std::int32_t z = 0; z < 6; ++z)
    for (std::int32_t y = 0; y < 11; ++y)
      for (std::int32_t x = 0; x < 12; ++x) {
        if (airspace.is_free(x, y, z)) continue;
        const Vector2 centre(x * 10 + 5, y * 10 + 5);
        RC_ASSERT(distance_to(zone.polygon, centre) <= margin + 5 * M_SQRT2 + 1e-6);
        RC_ASSERT(z * 10 <= zone.ceiling + margin + 1e-6);
        RC_ASSERT(z * 10 + 10 >= zone.floor - margin - 1e-6);
      }
}

RC_GTEST_PROP(AirspaceProperty, HasNoPointOfAFreeSegmentInABlockedVoxel, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  AirspaceGrid grid = grid_of(6, 5, 4, random.uniform(0.1, 30));
  grid.origin = {random.uniform(-1e5, 1e5), random.uniform(-1e5, 1e5), 20};
  const Airspace airspace = random_airspace(random, grid, 0.15);

  for (int i = 0; i < 100; ++i) {
    const Vector3 a = point_in(random, grid), b = point_in(random, grid);
    if (!airspace.is_free(a, b)) continue;
    for (int k = 0; k <= 500; ++k) RC_ASSERT(airspace.is_free(a + (b - a) * (k / 500.0)));
  }
}

RC_GTEST_PROP(AirspaceProperty, RefusesNoSegmentWhoseSurroundingsAreFree, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const AirspaceGrid grid = grid_of(6, 5, 4);
  const Airspace airspace = random_airspace(random, grid, 0.1);

  for (int i = 0; i < 100; ++i) {
    const Vector3 a = point_in(random, grid), b = point_in(random, grid);
    bool all = true;
    for (int k = 0; k <= 1000 && all; ++k) {
      const Vector3 at = a + (b - a) * (k / 1000.0);
      for (int corner = 0; corner < 8 && all; ++corner) {
        const Vector3 off((corner & 1) != 0 ? 0.1 : -0.1, (corner & 2) != 0 ? 0.1 : -0.1,
                          (corner & 4) != 0 ? 0.1 : -0.1);
        const auto voxel = airspace.voxel_at(at + off);
        all = !voxel || airspace.is_free(*voxel);
      }
    }
    if (all) RC_ASSERT(airspace.is_free(a, b));
  }
}

/// By how much the cost of a segment may depend on its direction: faces within kSnap of each other
/// along an axis are crossed at once, in the order of the axes.
double undecided(const AirspaceGrid& grid, const Vector3& from, const Vector3& to) {
  double share = 0;
  for (const double extent : Vector3((to - from).cwiseAbs() / grid.voxel))
    if (extent > 0) share += (std::ceil(extent) + 1) * std::min(1.0, Airspace::kSnap / extent);
  constexpr double kGreatestCost = 255 * Airspace::kCostStep;
  return share * kGreatestCost * (to - from).norm();
}

RC_GTEST_PROP(AirspaceProperty, AgreesWithItselfTurnedRound, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const AirspaceGrid grid = grid_of(6, 5, 4);
  const Airspace airspace = random_airspace(random, grid, 0.1);

  for (int i = 0; i < 100; ++i) {
    const Vector3 a = point_in(random, grid), b = point_in(random, grid);
    const auto there = airspace.cost(a, b), back = airspace.cost(b, a);
    RC_ASSERT(there.has_value() == back.has_value());
    RC_ASSERT(there.has_value() == airspace.is_free(a, b));
    if (there) RC_ASSERT(std::abs(*there - *back) <= 1e-9 * (1 + *there) + undecided(grid, a, b));
  }
}

RC_GTEST_PROP(AirspaceProperty, CostsTheSumOfItsSamples, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const AirspaceGrid grid = grid_of(6, 5, 4);
  const Airspace airspace = random_airspace(random, grid, 0);
  const Vector3 a = Vector3(random.uniform(0, 60), random.uniform(0, 50), random.uniform(0, 40));
  const Vector3 b = Vector3(random.uniform(0, 60), random.uniform(0, 50), random.uniform(0, 40));

  double sum = 0;
  constexpr int kSamples = 20'000;
  for (int k = 0; k < kSamples; ++k) {
    const Voxel at = *airspace.voxel_at(a + (b - a) * ((k + 0.5) / kSamples));
    sum += airspace.voxels()[grid.index(at[0], at[1], at[2])] / 16.0;
  }

  const double length = (b - a).norm();
  RC_ASSERT(std::abs(airspace.cost(a, b).value() - sum * length / kSamples) <= 2e-3 * length);
}

}  // namespace
}  // namespace skein::world
