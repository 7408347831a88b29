// SPDX-License-Identifier: Apache-2.0
// Heights over the ground along ways, and circles that keep some.
#include "common/heights_over.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>

#include "common/circles.hpp"
#include "skein/foundation/random.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

world::Terrain rough(Random& random) {
  world::TerrainSpec spec;
  spec.west = spec.south = -100;
  spec.east = 95;  // not a whole number of cells
  spec.north = 100;
  spec.cell = 20;
  for (int i = 0; i < 5; ++i)
    spec.hills.push_back({{random.uniform(-100, 100), random.uniform(-100, 100)},
                          random.uniform(-50, 80),
                          random.uniform(20, 90)});
  return world::Terrain(spec);
}

RC_GTEST_PROP(EvaluateHeights, AreThoseOfAThousandSamples, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const world::Terrain terrain = rough(random);
  const auto place = [&] {
    return Vector3(random.uniform(-150, 150), random.uniform(-150, 150), random.uniform(0, 100));
  };
  const Vector3 from = place(), to = random.chance(0.1) ? from + Vector3(0, 0, 40) : place();

  const HeightRange heights = heights_over(terrain, from, to);

  double least = 1e9, greatest = -1e9;
  for (int i = 0; i <= 1000; ++i) {
    const Vector3 at = from + i / 1000.0 * (to - from);
    const double height = at.z() - terrain.elevation(at.x(), at.y());
    least = std::min(least, height);
    greatest = std::max(greatest, height);
  }
  RC_ASSERT(heights.least <= least + 1e-9);
  RC_ASSERT(heights.least >= least - 1);  // what the samples may miss
  RC_ASSERT(heights.greatest >= greatest - 1e-9);
  RC_ASSERT(heights.greatest <= greatest + 1);
}

RC_GTEST_PROP(EvaluateHeights, AgreeWithTheFirstHitOfTheTerrain, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const world::Terrain terrain = rough(random);
  const Vector3 from(random.uniform(-95, 90), random.uniform(-95, 90), random.uniform(40, 120));
  const Vector3 to(random.uniform(-95, 90), random.uniform(-95, 90), random.uniform(40, 120));

  const double least = heights_over(terrain, from, to).least;

  RC_ASSERT(terrain.line_of_sight(from, to, least - 1e-6));
  RC_ASSERT(!terrain.line_of_sight(from, to, least + 1e-6));
}

// ---- circles -----------------------------------------------------------------------------------

world::Terrain with_hill_at(const Vector2& middle) {
  world::TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.cell = 10;
  spec.hills = {{middle, 60, 100}};
  return world::Terrain(spec);
}

TEST(Circles, AreFlownOnTheLeftOrWhereThatIsTooLowOnTheHigherSide) {
  const CircleRule rule{0.2, 40, 20};
  for (const double hill : {80.0, -80.0}) {
    const world::Terrain terrain = with_hill_at({0, hill});
    Way way = {{0, 0, terrain.elevation(0, 0) + 40}};
    add_circles(way, 120, Vector2::UnitX(), rule, terrain);

    EXPECT_EQ(way.back(), Vector3(0, 0, 120));
    for (std::size_t i = 1; i < way.size(); ++i) {
      EXPECT_GE(heights_over(terrain, way[i - 1], way[i]).least, 20);
      EXPECT_LE(way[i].y() * hill, 1e-6) << "away from the hill";
      EXPECT_LE(way[i].z() - way[i - 1].z(),
                0.2001 * (way[i] - way[i - 1]).head<2>().norm() + 1e-9);
    }
  }
}

TEST(Circles, StayOnTheLeftWhereBothSidesAreHighEnoughOrNoneIs) {
  for (const double least : {1.0, 500.0}) {
    const world::Terrain terrain = with_hill_at({0, 0});
    Way way = {{0, 0, 160}};
    add_circles(way, 130, Vector2::UnitX(), {0.2, 40, least}, terrain);
    for (const Vector3& point : way) EXPECT_GE(point.y(), -1e-9);
  }
}

}  // namespace
}  // namespace skein::refiners
