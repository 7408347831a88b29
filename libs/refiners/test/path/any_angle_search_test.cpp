// SPDX-License-Identifier: Apache-2.0
#include "path/any_angle_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "path/voxel_worlds.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using testing::free_voxel;
using testing::Mixture;
using testing::random_world;
using testing::samples_are_free;
using world::Airspace;
using world::Voxel;

constexpr double kNoBound = 1e12;

TEST(SearchAnyAngle, IsOneLegInFreeAir) {
  const Airspace airspace(testing::cube(40, 5));

  const AnyAngleWay found = search_any_angle(airspace, {1, 2, 3}, {33, 20, 11}, kNoBound, Budget());

  EXPECT_THAT(found.way,
              ::testing::ElementsAre(airspace.centre({1, 2, 3}), airspace.centre({33, 20, 11})));
}

TEST(SearchAnyAngle, FindsNoWayThatCostsTheBound) {
  Airspace airspace(testing::cube(30));
  airspace.keep_where([](const Voxel& at) { return at[0] != 15 || at[1] > 25; });

  EXPECT_THAT(search_any_angle(airspace, {2, 5, 5}, {28, 5, 5}, 27, Budget()).way,
              ::testing::IsEmpty());
  EXPECT_THAT(search_any_angle(airspace, {2, 5, 5}, {28, 5, 5}, 60, Budget()).way,
              ::testing::Not(::testing::IsEmpty()));
}

TEST(SearchAnyAngle, StopsWhenTheTimeIsUp) {
  Airspace airspace(testing::cube(40));
  airspace.keep_where([](const Voxel& at) { return at[0] != 20; });
  Budget budget;
  budget.time_is_up = [] { return true; };

  const AnyAngleWay found = search_any_angle(airspace, {0, 0, 0}, {39, 5, 5}, kNoBound, budget);

  EXPECT_TRUE(found.cut_short);
  EXPECT_THAT(found.way, ::testing::IsEmpty());
}

/// A long search hurries, but what it finds is still a way, and not much longer than around the
/// edge of the wall, which can be reckoned.
TEST(SearchAnyAngle, HurriesAfterManyNodesAndStaysNearTheShortestWay) {
  constexpr int kWall = 60, kEdge = 70;
  Airspace airspace(testing::cube(76));
  airspace.keep_where([](const Voxel& at) { return at[0] != kWall || at[1] > kEdge; });
  const Voxel from = {2, 5, 38}, to = {74, 5, 38};
  const double shortest =
      std::hypot(kWall - from[0], kEdge - from[1]) + std::hypot(kWall - to[0], kEdge - to[1]);

  const AnyAngleWay found = search_any_angle(airspace, from, to, kNoBound, Budget());

  EXPECT_GT(found.expanded, 200'000U);
  ASSERT_FALSE(found.way.empty());
  EXPECT_TRUE(samples_are_free(airspace, found.way));
  EXPECT_GE(length_of(found.way), shortest);
  EXPECT_LE(length_of(found.way), 1.1 * shortest);
}

/// Whether it finds a way exactly when the graph has one, and a free one.
void expect_free_way(std::uint64_t seed, double dear) {
  SCOPED_TRACE(seed);
  Random random(seed);
  Mixture mixture;
  mixture.blocked = random.uniform(0.05, 0.7);
  mixture.dear = dear;
  const Airspace airspace = random_world(random, testing::cube(16), mixture);
  const Voxel from = free_voxel(airspace, random), to = free_voxel(airspace, random);
  if (from == to) return;
  const bool reachable = search_graph(airspace, from, to, Budget()).found;

  const AnyAngleWay found = search_any_angle(airspace, from, to, kNoBound, Budget());

  ASSERT_EQ(!found.way.empty(), reachable);
  if (!reachable) return;
  EXPECT_EQ(found.way.front(), airspace.centre(from));
  EXPECT_EQ(found.way.back(), airspace.centre(to));
  EXPECT_TRUE(samples_are_free(airspace, found.way));
}

TEST(SearchAnyAngle, FindsFreeWaysExactlyWhenThereAreSome) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) expect_free_way(seed, 0);
}

/// What a search of the graph leaves is what other searches of it say, along the way found, and
/// never more anywhere.
TEST(GraphDistances, AreThoseOfTheGraphWhereItWasSearchedAndNoGreaterElsewhere) {
  constexpr double kFacet = 1.3;  // from any facet that was reached to the centre
  int along = 0, elsewhere = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const Airspace airspace = random_world(random, testing::cube(16), {.blocked = 0.4});
    const Voxel from = free_voxel(airspace, random), to = free_voxel(airspace, random);
    GraphSearch searched = search_graph_widely(airspace, from, to, Budget());
    if (from == to || !searched.distances) continue;
    for (const world::Vector3& point : searched.way.way) {
      const Voxel at = *airspace.free_voxel_at(point);
      if (at == from) continue;
      const double cost = search_graph(airspace, from, at, Budget()).cost;
      EXPECT_NEAR(searched.distances->from_start(at), cost, kFacet) << seed;
      ++along;
    }
    for (int i = 0; i < 20; ++i) {
      const Voxel at = free_voxel(airspace, random);
      const GraphWay there = search_graph(airspace, from, at, Budget());
      if (at == from || !there.found) continue;
      EXPECT_LE(searched.distances->from_start(at), there.cost + kFacet) << seed;
      ++elsewhere;
    }
  }
  EXPECT_GT(along, 300);
  EXPECT_GT(elsewhere, 300);
}

TEST(SearchAnyAngle, FindsTheSameWhenTheGraphHasBeenSearchedAndLooksAtLess) {
  double plain = 0, helped = 0;
  std::uint64_t looked = 0, looked_helped = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const Airspace airspace = random_world(random, testing::cube(32), {.blocked = 0.5});
    const Voxel from = free_voxel(airspace, random), to = free_voxel(airspace, random);
    GraphSearch searched = search_graph_widely(airspace, from, to, Budget());
    if (!searched.distances) continue;
    const AnyAngleWay alone = search_any_angle(airspace, from, to, kNoBound, Budget());

    const AnyAngleWay found =
        search_any_angle(airspace, from, to, kNoBound, Budget(), {.known = &*searched.distances});

    ASSERT_FALSE(found.way.empty()) << seed;
    EXPECT_EQ(found.way.front(), airspace.centre(from));
    EXPECT_EQ(found.way.back(), airspace.centre(to));
    EXPECT_TRUE(samples_are_free(airspace, found.way));
    plain += length_of(alone.way);
    helped += length_of(found.way);
    looked += alone.expanded;
    looked_helped += found.expanded;
  }
  EXPECT_LE(helped, 1.02 * plain);
  EXPECT_LT(looked_helped, looked);
}

TEST(SearchAnyAngle, FindsFreeWaysAtVariousCosts) {
  for (std::uint64_t seed = 500; seed < 560; ++seed) expect_free_way(seed, 0.7);
}

/// What the search takes for free the airspace does too, and mostly the other way round: a straight
/// way through a gap that no step leads through is not tried.
TEST(SearchAnyAngle, SeesAlongALegWhatTheAirspaceSays) {
  int straight = 0, missed = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    Mixture mixture;
    mixture.blocked = random.uniform(0.02, 0.2);
    const Airspace airspace = random_world(random, testing::cube(12), mixture);
    const Voxel from = free_voxel(airspace, random), to = free_voxel(airspace, random);
    if (from == to) continue;

    const Way way = search_any_angle(airspace, from, to, kNoBound, Budget()).way;

    for (std::size_t i = 1; i < way.size(); ++i)
      EXPECT_TRUE(airspace.is_free(way[i - 1], way[i])) << seed;
    if (!airspace.is_free(airspace.centre(from), airspace.centre(to))) continue;
    ++straight;
    missed += way.size() != 2 ? 1 : 0;
  }
  EXPECT_GT(straight, 80);
  EXPECT_LT(4 * missed, straight);
}

TEST(FindWay, QuicklyIsHardlyLonger) {
  double sum = 0, worst = 0, count = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    Random random(seed);
    Mixture mixture;
    mixture.blocked = random.uniform(0.05, 0.5);
    const Airspace airspace = random_world(random, testing::cube(20), mixture);
    const auto from = airspace.centre(free_voxel(airspace, random));
    const auto to = airspace.centre(free_voxel(airspace, random));
    const VoxelWay thorough = find_way(airspace, from, to, Budget());
    const VoxelWay quick = find_way(airspace, from, to, Budget(), WaySearch::kQuick);
    ASSERT_EQ(thorough.found, quick.found) << seed;
    if (!quick.found || thorough.cost == 0) continue;
    EXPECT_TRUE(samples_are_free(airspace, quick.way)) << seed;
    sum += quick.cost / thorough.cost;
    worst = std::max(worst, quick.cost / thorough.cost);
    count += 1;
  }
  EXPECT_LT(sum / count, 1.02) << "among voxels closed one by one, the hardest kind";
  EXPECT_LT(worst, 1.12);
}

}  // namespace
}  // namespace skein::refiners
