// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal/frontier.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/foundation/random.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

FrontierLink link(std::uint32_t from, std::uint32_t to, Ticks soonest, Ticks slowest,
                  Ticks latest = kMinusInfinite) {
  return {from, to, soonest, slowest, latest};
}

TEST(Eliminate, PutsPathsThroughInnerNodesTogether) {
  EXPECT_THAT(eliminate(4, 2, {link(0, 2, 1, 10), link(2, 3, 2, 20), link(3, 1, 3, 30)}),
              ElementsAre(link(0, 1, 6, 60)));
}

TEST(Eliminate, KeepsOfPathsTheOneThatAsksForMostInEachCourse) {
  EXPECT_THAT(eliminate(3, 2, {link(0, 1, 5, 5), link(0, 2, 1, 4), link(2, 1, 1, 4)}),
              ElementsAre(link(0, 1, 5, 8)));
}

TEST(Eliminate, SaysNothingOfWhatFollowsFromItsOwnArcs) {
  EXPECT_THAT(eliminate(3, 3, {link(0, 1, 1, 1), link(1, 2, 1, 1)}),
              ElementsAre(link(0, 1, 1, 1), link(1, 2, 1, 1)));
}

TEST(Eliminate, WhatNoFigureBoundsIsNotBoundedByWhatComesBehindIt) {
  EXPECT_THAT(eliminate(3, 2, {link(0, 2, 1, kInfinite), link(2, 1, 2, 3)}),
              ElementsAre(link(0, 1, 3, kInfinite)));
}

TEST(Eliminate, ACourseThatAsksForMoreAndMoreSaysNothing) {
  const FrontierLink round_there{2, 3, 1, 1, 7}, and_back{3, 2, -1, -1, -6};
  EXPECT_THAT(eliminate(4, 2, {link(0, 2, 0, 0, 0), round_there, and_back, link(3, 1, 0, 0, 0)}),
              ElementsAre(link(0, 1, 1, 1)));
}

// Distances between the nodes that are kept, by Floyd and Warshall.
std::vector<std::vector<Ticks>> distances(std::size_t nodes, const std::vector<FrontierLink>& links,
                                          Ticks FrontierArc::*weight) {
  std::vector<std::vector<Ticks>> d(nodes, std::vector<Ticks>(nodes, kMinusInfinite));
  for (std::size_t i = 0; i < nodes; ++i) d[i][i] = 0;
  for (const FrontierLink& one : links)
    d[one.from][one.to] = std::max(d[one.from][one.to], one.*weight);
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j)
        if (d[i][k] != kMinusInfinite && d[k][j] != kMinusInfinite)
          d[i][j] = std::max(d[i][j], d[i][k] + d[k][j]);
  return d;
}

TEST(Eliminate, KeepsDistancesBetweenWhatIsKept) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const std::size_t nodes = 4 + random.below(8), kept = 2 + random.below(nodes - 2);
    std::vector<FrontierLink> links;
    // Around a solution, so that no cycle asks for more than nothing.
    std::vector<Ticks> at;
    for (std::size_t i = 0; i < nodes; ++i) at.push_back(static_cast<Ticks>(random.below(100)));
    for (std::size_t i = 0; i < 3 * nodes; ++i) {
      const auto from = static_cast<std::uint32_t>(random.below(nodes));
      const auto to = static_cast<std::uint32_t>(random.below(nodes));
      if (from == to) continue;
      const Ticks most = at[to] - at[from];
      const auto less = [&] { return most - static_cast<Ticks>(random.below(20)); };
      links.push_back({from, to, less(), less(), less()});
    }

    const auto arcs = eliminate(nodes, kept, links);

    for (const auto weight : {&FrontierArc::soonest, &FrontierArc::slowest, &FrontierArc::latest}) {
      const auto all = distances(nodes, links, weight), left = distances(kept, arcs, weight);
      for (std::size_t i = 0; i < kept; ++i)
        for (std::size_t j = 0; j < kept; ++j)
          ASSERT_EQ(left[i][j], all[i][j]) << "seed " << seed << ", " << i << " to " << j;
    }
  }
}

TEST(AFrontier, IsRefusedForWhatMakesNone) {
  const Meeting meeting{501, {"a", "b"}, {"a", "b"}};
  EXPECT_EQ(fault_of({{meeting}, {link(0, 2, 1, 2, 2), link(2, 3, 1, kInfinite)}}), std::nullopt);
  EXPECT_THAT(*fault_of({{meeting, meeting}, {}}), HasSubstr("meeting 501 is there twice"));
  EXPECT_THAT(*fault_of({{meeting}, {link(0, 4 + kMostInnerNodes, 1, 2)}}),
              HasSubstr("arc 0 names a node"));
  EXPECT_THAT(*fault_of({{meeting}, {link(2, 2, 1, 2)}}), HasSubstr("to itself"));
  EXPECT_THAT(*fault_of({{meeting}, {link(0, 2, kFarthest + 1, 2)}}), HasSubstr("beyond"));
  EXPECT_THAT(*fault_of({{meeting}, {link(2, 3, kInfinite, 2)}}), HasSubstr("for ever"));
  EXPECT_THAT(*fault_of({{meeting}, {}, {{4, {}}}}), HasSubstr("at no meeting"));
}

}  // namespace
}  // namespace skein::temporal::testing
