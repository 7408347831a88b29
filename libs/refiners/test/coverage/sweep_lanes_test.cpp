// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "testing/coverage_cases.hpp"

namespace skein::refiners {
namespace {

using testing::rectangle;
using world::Polygon;

std::size_t count(const std::vector<Block>& blocks) {
  std::size_t lanes = 0;
  for (const Block& block : blocks) lanes += block.size();
  return lanes;
}

/// The extent of the region along x within a strip, from many level lines.
std::pair<double, double> sampled_extent(const Region& region, double low, double high) {
  double from = 1e300, to = -1e300;
  for (int i = 0; i <= 200; ++i) {
    const double y = low + (high - low) * (i + 0.5) / 201;
    for (std::size_t k = 0; k < region.outer.size(); ++k) {
      const auto& a = region.outer[k];
      const auto& b = region.outer[(k + 1) % region.outer.size()];
      if ((a.y() > y) == (b.y() > y)) continue;
      const double x = a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
      from = std::min(from, x);
      to = std::max(to, x);
    }
  }
  return {from, to};
}

TEST(LaneCount, IsTheWidthInSwathsRoundedUp) {
  EXPECT_EQ(lane_count(100, 10), 10U);
  EXPECT_EQ(lane_count(100.00000000001, 10), 10U) << "more by rounding only";
  EXPECT_EQ(lane_count(100.1, 10), 11U);
  EXPECT_EQ(lane_count(3, 10), 1U);
}

TEST(SweepFrame, TurnsInAndOutAgain) {
  const SweepFrame frame(0.7);

  const world::Vector2 there = frame.in(world::Vector2(3, 4));

  EXPECT_NEAR((frame.out(there) - world::Vector2(3, 4)).norm(), 0, 1e-12);
  EXPECT_NEAR(frame.in(world::Vector2(std::cos(0.7), std::sin(0.7))).y(), 0, 1e-12)
      << "the direction is along x";
}

TEST(WholeStrips, ARectangleGivesEqualLanes) {
  Block lanes;

  whole_strips(rectangle(10, 20, 110, 60), 15, lanes);

  ASSERT_EQ(lanes.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(lanes[i].y, 20 + (static_cast<double>(i) + 0.5) * 40 / 3, 1e-9);
    EXPECT_EQ(lanes[i].from, 10);
    EXPECT_EQ(lanes[i].to, 110);
  }
}

TEST(WholeStrips, ALaneRunsAsFarAsThePolygonDoesAnywhereInItsStrip) {
  Random random(1);

  for (int i = 0; i < 300; ++i) {
    const Region region{
        i % 2 == 0 ? testing::random_convex(random) : testing::random_star(random, 9), {}};
    Block lanes;
    whole_strips(region.outer, 40, lanes);
    const Breadth breadth = breadth_of(region.outer);
    const double height = breadth.width() / static_cast<double>(lanes.size());
    for (const Strip& lane : lanes) {
      const auto [from, to] = sampled_extent(region, lane.y - height / 2, lane.y + height / 2);
      ASSERT_LE(lane.from, from + 1e-9);
      ASSERT_GE(lane.to, to - 1e-9);
      ASSERT_GT(lane.from, from - 0.2 * (to - from) - 20) << "nor much farther";
    }
  }
}

TEST(SplitStrips, AConvexPolygonGivesTheSameLanesInOneBlock) {
  Random random(2);

  for (int i = 0; i < 300; ++i) {
    const Polygon polygon = testing::random_convex(random);
    Block whole;
    whole_strips(polygon, 35, whole);
    const auto blocks = split_strips({polygon, {}}, 35, 0);
    ASSERT_EQ(blocks.size(), 1U);
    ASSERT_EQ(blocks[0].size(), whole.size());
    for (std::size_t k = 0; k < whole.size(); ++k) {
      ASSERT_NEAR(blocks[0][k].from, whole[k].from, 1e-6);
      ASSERT_NEAR(blocks[0][k].to, whole[k].to, 1e-6);
    }
  }
}

/// Where borders of the region cross the level, and its corners between the levels.
std::vector<double> possible_ends(const Region& region, double low, double high) {
  std::vector<double> found;
  std::vector<Polygon> borders = region.holes;
  borders.push_back(region.outer);
  for (const Polygon& border : borders)
    for (std::size_t k = 0; k < border.size(); ++k) {
      const auto& a = border[k];
      const auto& b = border[(k + 1) % border.size()];
      if (a.y() >= low - 1e-9 && a.y() <= high + 1e-9) found.push_back(a.x());
      for (const double y : {low, high})
        if ((a.y() > y) != (b.y() > y))
          found.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  return found;
}

TEST(SplitStrips, WhatIsInAStarWithAHoleIsInALaneAndLanesEndWhereTheRegionDoes) {
  Random random(11);

  for (int i = 0; i < 60; ++i) {
    const auto corners = static_cast<std::size_t>(random.uniform(5, 120));
    const Region region{testing::random_star(random, corners, 150, 500),
                        {testing::random_star(random, 7, 20, 90)}};
    const double swath = random.uniform(8, 60);
    std::map<double, std::vector<Strip>> lanes;  // by their level
    for (const Block& block : split_strips(region, swath, 0))
      for (const Strip& lane : block) lanes[lane.y].push_back(lane);
    ASSERT_GT(lanes.size(), 1U);
    const double height = std::next(lanes.begin())->first - lanes.begin()->first;

    for (auto& [y, row] : lanes) {
      const auto ends = possible_ends(region, y - height / 2, y + height / 2);
      for (const Strip& lane : row)
        for (const double end : {lane.from, lane.to})
          ASSERT_TRUE(std::any_of(ends.begin(), ends.end(),
                                  [&](double x) { return std::abs(x - end) < 1e-6; }))
              << "case " << i << ": " << end << " at " << y;
      for (int k = 0; k < 40; ++k) {
        const world::Vector2 point(random.uniform(-500, 500),
                                   y + random.uniform(-0.499, 0.499) * height);
        if (!world::contains(region.outer, point) || world::contains(region.holes[0], point))
          continue;
        const auto swept = std::count_if(row.begin(), row.end(), [&](const Strip& lane) {
          return lane.from <= point.x() && point.x() <= lane.to;
        });
        ASSERT_EQ(swept, 1) << "case " << i << ": " << point.transpose();
      }
    }
  }
}

TEST(SplitStrips, AHoleSplitsLanesIntoFourBlocks) {
  const Region region{rectangle(0, 0, 100, 60), {rectangle(40, 20, 60, 40)}};

  const auto blocks = split_strips(region, 10, 0);

  ASSERT_EQ(blocks.size(), 4U) << "below, left, right, above";
  EXPECT_EQ(count(blocks), 8U);
  EXPECT_EQ(blocks[1][0].to, 40);
  EXPECT_EQ(blocks[2][0].from, 60);
}

TEST(SplitStrips, AGapThatIsAllowedDoesNotSplit) {
  const Region region{rectangle(0, 0, 100, 60), {rectangle(40, 20, 60, 40)}};

  EXPECT_EQ(split_strips(region, 10, 25).size(), 1U);
  EXPECT_EQ(split_strips(region, 10, 15).size(), 4U);
}

TEST(SplitStrips, TheLegsOfAUAreBlocks) {
  const Region region{{{0, 0}, {90, 0}, {90, 60}, {60, 60}, {60, 30}, {30, 30}, {30, 60}, {0, 60}},
                      {}};

  const auto blocks = split_strips(region, 10, 0);

  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(blocks[0].size(), 3U);
  EXPECT_EQ(blocks[1].size(), 3U);
  EXPECT_EQ(blocks[2].size(), 3U);
}

TEST(SplitStrips, EveryPointOfTheRegionIsInTheStripOfALane) {
  Random random(6);

  for (int i = 0; i < 200; ++i) {
    const Region region{testing::random_star(random, 12, 250, 500),
                        {testing::random_star(random, 5, 50, 150)}};
    const auto blocks = split_strips(region, 30, 0);
    for (int k = 0; k < 300; ++k) {
      const world::Vector2 point(random.uniform(-500, 500), random.uniform(-500, 500));
      if (!world::contains(region.outer, point) || world::contains(region.holes[0], point))
        continue;
      bool held = false;
      for (const Block& block : blocks)
        for (const Strip& strip : block)
          held = held || (std::abs(point.y() - strip.y) <= 15 + 1e-9 &&
                          point.x() >= strip.from - 1e-9 && point.x() <= strip.to + 1e-9);
      ASSERT_TRUE(held) << point.transpose();
    }
  }
}

}  // namespace
}  // namespace skein::refiners
