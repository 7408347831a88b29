// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "path/facet_graph.hpp"
#include "path/facet_table.hpp"
#include "path/voxel_worlds.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "test_cases.hpp"

namespace skein::refiners {
namespace {

using testing::free_voxel;
using testing::Mixture;
using testing::PlainDijkstra;
using testing::random_world;
using world::Airspace;
using world::Voxel;

constexpr double kRoot = 0.70710678118654752;

/// What the best way would cost in free air, by the definition of the graph.
double free_cost(const Voxel& from, const Voxel& to) {
  std::array<double, 3> offset{};
  for (std::size_t i = 0; i < 3; ++i) offset[i] = std::abs(to[i] - from[i]);
  std::sort(offset.begin(), offset.end());
  const double least = offset[0] + offset[1];
  if (offset[2] >= least) return offset[2] - least + least * 2 * kRoot;
  return (offset[0] + offset[1] + offset[2]) * kRoot;
}

void expect_as_dijkstra(const Airspace& airspace, const Voxel& from, const Voxel& to) {
  const auto expected = PlainDijkstra(airspace).cost(from, to);

  const GraphWay found = search_graph(airspace, from, to, Budget());

  ASSERT_EQ(found.found, expected.has_value());
  EXPECT_FALSE(found.out_of_budget);
  if (!expected) return;
  EXPECT_NEAR(found.cost, *expected, 1e-5 * *expected + 1e-9);
  double along = 0;
  for (std::size_t i = 1; i < found.way.size(); ++i) {
    const auto leg = airspace.cost(found.way[i - 1], found.way[i]);
    ASSERT_TRUE(leg.has_value()) << "leg " << i;
    along += *leg;
  }
  EXPECT_NEAR(along, found.cost, 1e-9 * (1 + along)) << "the cost is that of the way given";
  EXPECT_EQ(found.way.front(), airspace.centre(from));
  EXPECT_EQ(found.way.back(), airspace.centre(to));
}

TEST(SearchGraph, CostsWhatDijkstraDoesInRandomWorlds) {
  const auto worlds = skein::testing::cases<std::uint64_t>(60, 500);
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Mixture mixture;
    mixture.blocked = random.uniform(0.1, 0.72);
    mixture.boxes = static_cast<int>(random.below(30));
    if (seed % 2 == 1) mixture.dear = random.uniform(0.1, 1);
    const Airspace airspace = random_world(random, testing::cube(24), mixture);

    expect_as_dijkstra(airspace, free_voxel(airspace, random), free_voxel(airspace, random));
  }
}

TEST(SearchGraph, CostsWhatDijkstraDoesInThinAndOddGrids) {
  for (const std::array<std::int32_t, 3>& size :
       {Voxel{1, 1, 9}, Voxel{17, 1, 3}, Voxel{2, 33, 2}, Voxel{9, 10, 1}, Voxel{65, 8, 9}})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Random random(seed);
      world::AirspaceGrid grid = testing::cube(1, 7.5);
      grid.size = size;
      grid.origin = {-100, 2000, 50};
      Mixture mixture;
      mixture.blocked = 0.15;
      mixture.dear = 0.5;
      const Airspace airspace = random_world(random, grid, mixture);

      expect_as_dijkstra(airspace, free_voxel(airspace, random), free_voxel(airspace, random));
    }
}

TEST(SearchGraph, CostsWhatFreeAirAllows) {
  const Airspace airspace(testing::cube(20));
  Random random(3);

  for (int i = 0; i < 50; ++i) {
    const Voxel from = free_voxel(airspace, random), to = free_voxel(airspace, random);

    const double cost = search_graph(airspace, from, to, Budget()).cost;
    EXPECT_GE(cost, free_cost(from, to) - 1e-9);
    EXPECT_LE(cost, free_cost(from, to) + 2 * (1 - kRoot)) << "it leaves and arrives straight";
  }
}

TEST(SearchGraph, StaysWhenItIsThere) {
  const Airspace airspace(testing::cube(3));

  const GraphWay found = search_graph(airspace, {1, 1, 1}, {1, 1, 1}, Budget());

  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.cost, 0);
  EXPECT_THAT(found.way, ::testing::ElementsAre(airspace.centre({1, 1, 1})));
}

TEST(SearchGraph, IsTheSameTwice) {
  Random random(5);
  const Airspace airspace = random_world(random, testing::cube(24), Mixture());
  const Voxel from = free_voxel(airspace, random), to = free_voxel(airspace, random);

  const GraphWay once = search_graph(airspace, from, to, Budget());
  const GraphWay again = search_graph(airspace, from, to, Budget());

  EXPECT_EQ(once.way, again.way);
  EXPECT_EQ(once.expanded, again.expanded);
}

TEST(SearchGraph, EndsWithItsSteps) {
  const Airspace airspace(testing::cube(30));
  Budget budget;
  budget.steps = 10;

  const GraphWay found = search_graph(airspace, {0, 0, 0}, {29, 20, 10}, budget);

  EXPECT_FALSE(found.found);
  EXPECT_TRUE(found.out_of_budget);
  EXPECT_FALSE(found.cut_short) << "not by the clock";
}

TEST(SearchGraph, EndsWithItsTime) {
  Airspace airspace(testing::cube(60));
  airspace.keep_where([](const Voxel& at) { return at[0] < 50 || at[0] == 59; });
  Budget budget;
  budget.time_is_up = [] { return true; };

  const GraphWay found = search_graph(airspace, {0, 0, 0}, {59, 20, 10}, budget);

  EXPECT_TRUE(found.cut_short);
  EXPECT_LE(found.expanded, 1024U);
}

/// A cube of air around which nothing leads to the middle.
Airspace shut_off(std::int32_t side, std::int32_t radius) {
  Airspace airspace(testing::cube(side));
  airspace.keep_where([&](const Voxel& at) {
    std::int32_t farthest = 0;
    for (const std::int32_t along : at) farthest = std::max(farthest, std::abs(along - side / 2));
    return farthest != radius;
  });
  return airspace;
}

TEST(SearchGraph, SeesEarlyThatTheGoalIsShutOff) {
  const Airspace airspace = shut_off(80, 4);

  const GraphWay found = search_graph(airspace, {0, 0, 0}, {40, 40, 40}, Budget());

  EXPECT_FALSE(found.found);
  EXPECT_FALSE(found.out_of_budget);
  EXPECT_LE(found.expanded, 1U << 14U) << "of 1.5 million";
}

TEST(SearchGraph, SeesThatALargeGoalIsShutOff) {
  const Airspace airspace = shut_off(110, 30);

  const GraphWay found = search_graph(airspace, {0, 0, 0}, {55, 55, 55}, Budget());

  EXPECT_FALSE(found.found);
  EXPECT_FALSE(found.out_of_budget);
  EXPECT_LE(found.expanded, 1U << 20U) << "of 3.3 million";
}

/// Free but for a thin pipe along x, closed at its near end.
Airspace pipe(std::int32_t side, std::int32_t near, std::int32_t mouth) {
  Airspace airspace(testing::cube(side));
  airspace.keep_where([&](const Voxel& at) {
    const std::int32_t off = std::max(std::abs(at[1] - side / 2), std::abs(at[2] - side / 2));
    const bool wall = off == 1 && at[0] >= near && at[0] <= mouth;
    return !wall && !(off == 0 && at[0] == near);
  });
  return airspace;
}

TEST(SearchGraph, IsLongOnlyWhereItIsLongFromBothEnds) {
  const Airspace airspace = pipe(130, 60, 120);
  const Voxel outside{5, 65, 65}, in_the_pipe{61, 65, 65};

  const GraphWay into = search_graph(airspace, outside, in_the_pipe, Budget());
  const GraphWay out_of = search_graph(airspace, in_the_pipe, outside, Budget());

  ASSERT_TRUE(into.found && out_of.found);
  EXPECT_NEAR(into.cost, out_of.cost, 1e-6 * into.cost);
  EXPECT_EQ(into.way.front(), airspace.centre(outside));
  EXPECT_EQ(into.way.back(), airspace.centre(in_the_pipe));
  EXPECT_LE(out_of.expanded, 1U << 16U) << "the pipe leads out";
  EXPECT_LE(into.expanded, (1U << 18U) + 5 * out_of.expanded) << "of 6 million";
}

RC_GTEST_PROP(FacetHeuristicProperty, IsConsistentAtLeastCost, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto any = [&] {
    return Voxel{static_cast<std::int32_t>(random.below(40)),
                 static_cast<std::int32_t>(random.below(40)),
                 static_cast<std::int32_t>(random.below(40))};
  };
  const auto scale = static_cast<std::int64_t>(1 + random.below(255));
  const Voxel goal = any();
  const FacetHeuristic heuristic(goal, scale);

  for (int i = 0; i < 200; ++i) {
    const Voxel voxel = any();
    for (Facet a = 0; a < 6; ++a) {
      for (Facet b = 0; b < 6; ++b) {
        if (a == b) continue;
        const std::int64_t step =
            scale * (b == opposite(a) ? FacetCosts::kOpposite : FacetCosts::kAdjacent);
        RC_ASSERT(heuristic(voxel, a) <= step + heuristic(voxel, b));
      }
      RC_ASSERT(heuristic(voxel, a) == heuristic(beyond(voxel, a), opposite(a)));
      RC_ASSERT(heuristic(goal, a) == scale * FacetCosts::kToCentre);
    }
  }
}

RC_GTEST_PROP(FacetTableProperty, KeepsTheDifferenceOfCostsThatAreNotFarApart, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  FacetTable table(testing::cube(10));
  const auto cost = static_cast<std::int64_t>(random.below(1U << 30U));
  const auto other = cost + static_cast<std::int64_t>(random.below(700'000)) - 350'000;

  for (Facet facet = 0; facet < 3; ++facet) {
    FacetTable::Slot slot = table.slot({3, 4, 5}, 2 * facet);
    RC_ASSERT(!slot.known());
    slot.keep(cost + static_cast<std::int64_t>(facet));
  }

  for (Facet facet = 0; facet < 3; ++facet) {
    const FacetTable::Slot slot = table.slot({3, 4, 5}, 2 * facet);
    RC_ASSERT(slot.known());
    RC_ASSERT(slot.above(other) == cost + static_cast<std::int64_t>(facet) - other);
    RC_ASSERT(table.slot(beyond({3, 4, 5}, 2 * facet), 2 * facet + 1).above(other) ==
              slot.above(other));
  }
}

TEST(Passage, IsPackedAndUnpacked) {
  const Passage passage{{(1 << 20) - 1, 12345, 0}, 5};

  const Passage back = unpacked(packed(passage));

  EXPECT_EQ(back.into, passage.into);
  EXPECT_EQ(back.facet, passage.facet);
}

}  // namespace
}  // namespace skein::refiners
