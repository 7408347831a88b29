// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_planner.hpp"

#include <gtest/gtest.h>

#include "testing/builders.hpp"
#include "testing/coverage_cases.hpp"

namespace skein::refiners {
namespace {

using testing::rectangle;
using world::Polygon;
using world::Vector2;

TEST(ConvexHull, HoldsEveryCornerAndIsConvex) {
  Random random(31);

  for (int i = 0; i < 200; ++i) {
    const Polygon star = testing::random_star(random, 12);
    const Polygon hull = convex_hull(star);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Vector2 &a = hull[k], &b = hull[(k + 1) % hull.size()];
      for (const Vector2& corner : star)
        ASSERT_GE((b - a).x() * (corner - a).y() - (b - a).y() * (corner - a).x(), -1e-6);
    }
    EXPECT_TRUE(is_convex(hull));
  }
}

TEST(IsConvex, TellsAnLFromARectangle) {
  EXPECT_TRUE(is_convex(rectangle(0, 0, 3, 2)));
  EXPECT_TRUE(is_convex({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})) << "a corner on a side";
  EXPECT_FALSE(is_convex({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}));
}

TEST(LongestLine, OfAHoledRectanglePassesBesideTheHole) {
  const Region plain{rectangle(0, 0, 100, 10), {}};
  const Region holed{rectangle(0, 0, 100, 10), {rectangle(45, 2, 55, 8)}};

  EXPECT_NEAR(std::abs(std::tan(longest_line(plain))), 0.1, 1e-9);
  EXPECT_LT(std::abs(std::tan(longest_line(holed))), 0.05);
}

TEST(LongestLine, IsAsLongAsAnyChordBetweenCornersThatStaysInside) {
  Random random(32);

  for (int i = 0; i < 10; ++i) {
    const Polygon star = testing::random_star(random, 7);
    const double direction = longest_line({star, {}});
    const Vector2 along(std::cos(direction), std::sin(direction));
    double longest_along = 0, longest = 0;
    const auto stays_inside = [&](const Vector2& a, const Vector2& b) {
      for (int k = 1; k < 200; ++k)
        if (!world::contains(star, a + (b - a) * (k / 200.0))) return false;
      return true;
    };
    for (const Vector2& a : star)
      for (const Vector2& b : star)
        if (stays_inside(a, b)) longest = std::max(longest, (b - a).norm());
    for (const Vector2& corner : star)
      for (double length = 0; length < 1000; length += 2)
        for (const double back : {-1.0, 1.0})
          if (stays_inside(corner, corner + back * length * along))
            longest_along = std::max(longest_along, length);
    EXPECT_GE(longest_along, longest - 4) << "case " << i;
  }
}

TEST(PlanSweep, GivesNothingWhereNoLaneMayBeFlown) {
  const TurnModel model(testing::helicopter(), 10);
  SweepTask task;
  task.region.outer = rectangle(0, 0, 300, 200);
  task.swath = 30;
  task.is_free = [](const Vector2&, const Vector2&) { return false; };
  const Budget budget;
  Countdown countdown(budget);

  EXPECT_FALSE(plan_sweep(task, model, countdown));
}

TEST(PlanSweep, ANarrowGapIsFlownOverAndAWideOneIsNot) {
  const TurnModel model(testing::helicopter(), 10);
  SweepTask task;
  task.swath = 30;
  task.mode = SweepMode::kGiven;
  const Budget budget;
  Countdown countdown(budget);
  task.region = {rectangle(0, 0, 2000, 300), {rectangle(990, 100, 1010, 200)}};

  EXPECT_EQ(plan_sweep(task, model, countdown)->blocks, 1U);
  task.region.holes = {rectangle(200, 30, 1800, 270)};
  EXPECT_EQ(plan_sweep(task, model, countdown)->blocks, 4U);
}

TEST(PlanSweep, ThousandsOfLanesAreStillPlannedSoon) {
  const TurnModel model(testing::helicopter(), 10);
  SweepTask task;
  task.region.outer = rectangle(0, 0, 5000, 4000);
  task.swath = 0.5;
  const Budget budget;
  Countdown countdown(budget);

  EXPECT_EQ(plan_sweep(task, model, countdown)->passes.size(), 8000U);
}

}  // namespace
}  // namespace skein::refiners
