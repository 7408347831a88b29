// SPDX-License-Identifier: Apache-2.0
#include "any_angle_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/refiners/voxel_path_planner.hpp"
#include "voxel_worlds.hpp"

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

TEST(SearchAnyAngle, FindsFreeWaysAtVariousCosts) {
  for (std::uint64_t seed = 500; seed < 560; ++seed) expect_free_way(seed, 0.7);
}

}  // namespace
}  // namespace skein::refiners
