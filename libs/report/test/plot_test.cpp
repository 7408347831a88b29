// SPDX-License-Identifier: Apache-2.0
#include "plot.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

namespace skein::report {
namespace {

TEST(Axis, IsLinearAndMayRunDownwards) {
  const Axis axis{0, 10, 100, 50};

  EXPECT_DOUBLE_EQ(axis(0), 100);
  EXPECT_DOUBLE_EQ(axis(10), 50);
  EXPECT_DOUBLE_EQ(axis(5), 75);
}

TEST(RoundStep, IsTheNextOfOneTwoFive) {
  EXPECT_DOUBLE_EQ(round_step(0.7), 1);
  EXPECT_DOUBLE_EQ(round_step(1.2), 2);
  EXPECT_DOUBLE_EQ(round_step(30), 50);
  EXPECT_DOUBLE_EQ(round_step(51), 100);
  EXPECT_DOUBLE_EQ(round_step(0), 1);
  EXPECT_DOUBLE_EQ(round_step(std::nan("")), 1);
}

TEST(RoundTimeStep, FollowsTheClock) {
  EXPECT_DOUBLE_EQ(round_time_step(0.2), 1);
  EXPECT_DOUBLE_EQ(round_time_step(12), 15);
  EXPECT_DOUBLE_EQ(round_time_step(61), 120);
  EXPECT_DOUBLE_EQ(round_time_step(4000), 7200);
  EXPECT_DOUBLE_EQ(round_time_step(3 * 86400.0), 5 * 86400.0);
}

TEST(Ticks, AreTheMultiplesWithinTheRange) {
  EXPECT_EQ(ticks(-1, 5, 2), (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(ticks(0, 6, 2), (std::vector<double>{0, 2, 4, 6}));
  EXPECT_TRUE(ticks(0, 1, 0).empty());
  EXPECT_TRUE(ticks(0, 1e9, 1).empty());
}

double distance_to_line(Point p, const std::vector<Point>& line) {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    // Sampled finely: slow, and independent of the code under test.
    for (int k = 0; k <= 400; ++k) {
      const double part = k / 400.0;
      const double x = line[i].x + (line[i + 1].x - line[i].x) * part;
      const double y = line[i].y + (line[i + 1].y - line[i].y) * part;
      best = std::min(best, std::hypot(p.x - x, p.y - y));
    }
  }
  return best;
}

RC_GTEST_PROP(Simplified, EveryPointStaysWithinTheTolerance, ()) {
  const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-20, 20), rc::gen::inRange(-20, 20)));
  std::vector<Point> line;
  for (const auto& [x, y] : steps) line.push_back({static_cast<double>(x), static_cast<double>(y)});

  const std::vector<Point> result = simplified(line, 2.0, 1000);

  RC_ASSERT(result.size() <= line.size());
  if (line.size() >= 2) {
    for (const Point& p : line) RC_ASSERT(distance_to_line(p, result) <= 2.0 + 0.15);
    RC_ASSERT(result.front().x == line.front().x && result.back().y == line.back().y);
  }
}

TEST(Simplified, AStraightLineKeepsItsEnds) {
  std::vector<Point> line;
  for (int i = 0; i < 1000; ++i) line.push_back({static_cast<double>(i), 2.0 * i});

  EXPECT_EQ(simplified(line, 0.1, 100).size(), 2U);
}

TEST(Simplified, ARaggedLineIsCutToTheMost) {
  std::vector<Point> line;
  for (int i = 0; i < 1000; ++i) line.push_back({static_cast<double>(i), i % 2 == 0 ? 5.0 : -5.0});

  EXPECT_LE(simplified(line, 0.1, 50).size(), 50U);
}

TEST(LabelPlacer, NoTwoLabelsOverlap) {
  LabelPlacer placer({0, 0, 300, 300});
  std::vector<Box> boxes;
  int placed_count = 0;

  for (int i = 0; i < 40; ++i) {
    const auto placed = placer.place({150, 150.0 + i}, 3, "label", 10);
    if (!placed) continue;
    ++placed_count;
    const double width = text_width("label", 10);
    const std::string_view anchor = placed->anchor;
    const double left = placed->x - (anchor == "start" ? 0 : anchor == "end" ? width : width / 2);
    const Box box{left, placed->y - 8, left + width, placed->y + 2};
    for (const Box& other : boxes) EXPECT_FALSE(box.overlaps(other));
    boxes.push_back(box);
  }

  EXPECT_GE(placed_count, 5);
}

TEST(LabelPlacer, StaysInsideTheAreaAndOffWhatIsBlocked) {
  LabelPlacer placer({0, 0, 100, 100});
  placer.block({0, 0, 100, 60});

  EXPECT_FALSE(placer.place({50, 30}, 3, "x", 10));
  EXPECT_FALSE(placer.place({500, 500}, 3, "x", 10));
  EXPECT_TRUE(placer.place({50, 80}, 1, "x", 8));
}

TEST(LabelPlacer, KeepsOffWhatIsToBeAvoidedWhereItCan) {
  LabelPlacer placer({0, 0, 200, 200});
  placer.avoid({115, 100});

  const auto placed = placer.place({100, 100}, 4, "name", 10);

  ASSERT_TRUE(placed);
  EXPECT_STREQ(placed->anchor, "end");
}

TEST(LabelPlacer, TakesTheLeastBadSideWhenAllAreToBeAvoided) {
  LabelPlacer placer({0, 0, 200, 200});
  for (int x = 0; x < 200; x += 2) {
    for (int y = 0; y < 200; y += 2) placer.avoid({x + 0.5, y + 0.5});
  }

  EXPECT_TRUE(placer.place({100, 100}, 4, "name", 10));
}

TEST(LabelPlacer, PrefersTheRightSide) {
  LabelPlacer placer({0, 0, 200, 200});

  const auto placed = placer.place({100, 100}, 4, "name", 10);

  ASSERT_TRUE(placed);
  EXPECT_STREQ(placed->anchor, "start");
  EXPECT_DOUBLE_EQ(placed->x, 107);
}

}  // namespace
}  // namespace skein::report
