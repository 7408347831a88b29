// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/voxel_worlds.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using testing::free_voxel;
using testing::Mixture;
using testing::random_world;
using testing::samples_are_free;
using world::Airspace;
using world::Vector3;
using world::Voxel;

double cost_of(const Airspace& airspace, const Way& way) {
  double sum = 0;
  for (std::size_t i = 1; i < way.size(); ++i)
    sum += airspace.cost(way[i - 1], way[i]).value_or(1e300);
  return sum;
}

TEST(PullStraight, LeavesAStraightLineInFreeAir) {
  const Airspace airspace(testing::cube(40));
  const GraphWay raw = search_graph(airspace, {1, 2, 3}, {35, 30, 20}, Budget());

  const Way way = pull_straight(airspace, raw.way);

  EXPECT_THAT(way,
              ::testing::ElementsAre(airspace.centre({1, 2, 3}), airspace.centre({35, 30, 20})));
}

TEST(PullStraight, GoesTautRoundAnEdge) {
  Airspace airspace(testing::cube(40));
  airspace.keep_where([](const Voxel& at) { return at[0] != 20 || at[2] >= 30; });
  const Vector3 from = airspace.centre({2, 10, 5}), to = airspace.centre({37, 30, 5});
  const GraphWay raw = search_graph(airspace, {2, 10, 5}, {37, 30, 5}, Budget());

  const Way way = pull_straight(airspace, raw.way);

  // Over the wall's upper edges, unrolled: up, over one voxel, down, in a straight line.
  const double up = std::hypot(17.5, 24.5), over = 1, down = std::hypot(16.5, 24.5);
  const double taut = std::hypot(up + over + down, 20);
  EXPECT_NEAR(length_of(way), taut, 0.002 * taut);
  EXPECT_EQ(way.front(), from);
  EXPECT_EQ(way.back(), to);
}

TEST(PullStraight, DoesNotGoThroughDearAirForShortness) {
  Airspace airspace(testing::cube(30));
  world::Volume dear;
  dear.polygon = {{10.2, 3.2}, {19.8, 3.2}, {19.8, 27.8}, {10.2, 27.8}};
  airspace.set_cost(dear, 15);
  const GraphWay raw = search_graph(airspace, {3, 14, 14}, {27, 14, 14}, Budget());

  const Way way = pull_straight(airspace, raw.way);

  EXPECT_LE(cost_of(airspace, way), raw.cost);
  EXPECT_NEAR(cost_of(airspace, way), length_of(way), 1e-9) << "round it, though it is longer";
  EXPECT_GT(length_of(way), 30);
}

TEST(PullStraight, StopsWhenTheTimeIsUp) {
  Random random(1);
  const Airspace airspace = random_world(random, testing::cube(24), Mixture());
  GraphWay raw;
  while (!raw.found)
    raw = search_graph(airspace, free_voxel(airspace, random), free_voxel(airspace, random), {});
  Budget budget;
  budget.time_is_up = [] { return true; };

  EXPECT_EQ(pull_straight(airspace, raw.way, budget), raw.way);
}

TEST(PullStraight, KeepsWaysOfOneOrTwoPoints) {
  const Airspace airspace(testing::cube(3));

  EXPECT_EQ(pull_straight(airspace, {{1, 1, 1}}), (Way{{1, 1, 1}}));
  EXPECT_EQ(pull_straight(airspace, {{1, 1, 1}, {2, 2, 2}}), (Way{{1, 1, 1}, {2, 2, 2}}));
}

/// Of a free, pulled way whatever the world.
void expect_better_and_free(std::uint64_t seed, bool dear) {
  SCOPED_TRACE(seed);
  Random random(seed);
  Mixture mixture;
  mixture.blocked = random.uniform(0, 0.4);
  mixture.boxes = static_cast<int>(random.below(60));
  mixture.dear = dear ? random.uniform(0.1, 1) : 0;
  mixture.dearest = 80;
  const Airspace airspace = random_world(random, testing::cube(24, 3.7), mixture);
  const GraphWay raw =
      search_graph(airspace, free_voxel(airspace, random), free_voxel(airspace, random), Budget());
  if (!raw.found) return;

  const Way way = pull_straight(airspace, raw.way);

  EXPECT_LE(cost_of(airspace, way), raw.cost * (1 + 1e-12) + 1e-12);
  EXPECT_TRUE(samples_are_free(airspace, way));
  EXPECT_EQ(way.front(), raw.way.front());
  EXPECT_EQ(way.back(), raw.way.back());
  EXPECT_EQ(way, pull_straight(airspace, raw.way)) << "the same twice";
}

TEST(PullStraight, IsFreeAndNeverLonger) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) expect_better_and_free(seed, false);
}

TEST(PullStraight, IsFreeAndNeverDearer) {
  for (std::uint64_t seed = 1000; seed < 1100; ++seed) expect_better_and_free(seed, true);
}

}  // namespace
}  // namespace skein::refiners
