// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/coverage.hpp"

#include <gtest/gtest.h>

#include "skein/refiners/flyable.hpp"
#include "test_cases.hpp"
#include "testing/builders.hpp"
#include "testing/coverage_cases.hpp"

namespace skein::refiners {
namespace {

using testing::covered;
using testing::fixed_wing;
using testing::helicopter;
using testing::random_convex;
using testing::random_star;
using testing::rectangle;
using world::Polygon;
using world::Vector2;
using world::Vector3;

constexpr double kPi = std::numbers::pi;

CoverageQuery query_of(Polygon area, double swath = 40) {
  CoverageQuery query;
  query.vehicle = helicopter();
  query.vehicle.energy.capacity = 1e12;
  query.area = std::move(area);
  query.swath = swath;
  query.altitude = 60;
  return query;
}

class CoverageTest : public ::testing::Test {
 protected:
  Refined<Coverage> swept(const CoverageQuery& query) const {
    auto outcome = refine(query, setting_);
    EXPECT_TRUE(outcome) << outcome.error().field << ": " << outcome.error().why;
    return outcome ? *outcome : Refined<Coverage>{};
  }
  double best_of_every_degree(CoverageQuery query) const {
    query.mode = SweepMode::kGiven;
    double least = 1e300;
    for (int degree = 0; degree < 180; ++degree) {
      query.direction = degree * kPi / 180;
      least = std::min(least, swept(query).cost);
    }
    return least;
  }

  world::World world_ = testing::level_world();
  Setting setting_{world_, {}, 1, nullptr};
};

int cases(int few, int all) { return skein::testing::cases(few, all); }

/// The least distance between two parallels that hold the polygon, from every edge.
double least_width(const Polygon& polygon) {
  double least = 1e300;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 edge = (polygon[(i + 1) % polygon.size()] - polygon[i]).normalized();
    double farthest = 0;
    for (const Vector2& corner : polygon) {
      const Vector2 offset = corner - polygon[i];
      farthest = std::max(farthest, std::abs(edge.x() * offset.y() - edge.y() * offset.x()));
    }
    least = std::min(least, farthest);
  }
  return least;
}

/// Time of a sweep of a convex polygon by one that hovers, from sampled chords and the words of the
/// turn model alone.
double own_sweep_time(const CoverageQuery& query, double direction) {
  const double v = query.vehicle.cruise_speed, a = query.vehicle.acceleration;
  const auto moved = [&](double d) {
    return d >= v * v / a ? d / v + v / a : 2 * std::sqrt(d / a);
  };
  const Vector2 along(std::cos(direction), std::sin(direction));
  const Vector2 across(-along.y(), along.x());
  double low = 1e300, high = -1e300;
  for (const Vector2& corner : query.area) {
    low = std::min(low, across.dot(corner));
    high = std::max(high, across.dot(corner));
  }
  const double count = std::ceil((high - low) / query.swath - 1e-9), step = (high - low) / count;
  double sum = 0, last = 0;
  for (double i = 0; i < count; ++i) {
    double from = 1e300, to = -1e300;
    for (int k = 0; k <= 400; ++k) {
      const double y = low + step * (i + k / 400.0);
      for (std::size_t c = 0; c < query.area.size(); ++c) {
        const Vector2 p = query.area[c], q = query.area[(c + 1) % query.area.size()];
        const double a_side = across.dot(p) - y, b_side = across.dot(q) - y;
        if ((a_side > 1e-9) == (b_side > 1e-9)) continue;
        const double x = along.dot(p + (q - p) * (a_side / (a_side - b_side)));
        from = std::min(from, x);
        to = std::max(to, x);
      }
    }
    const bool forth = std::fmod(i, 2) == 0;
    if (i > 0)
      sum += std::max(moved(std::hypot(step, (forth ? from : to) - last)),
                      kPi / query.vehicle.yaw_rate);
    sum += moved(to - from);
    last = forth ? to : from;
  }
  return sum;
}

TEST_F(CoverageTest, ARectangleIsSweptAlongItsLongSide) {
  const auto refined = swept(query_of(rectangle(0, 0, 400, 100), 25));

  EXPECT_NEAR(refined.task.direction, 0, 1e-12);
  ASSERT_EQ(refined.task.lanes.size(), 4U);
  EXPECT_EQ(refined.task.turns, 3U);
  EXPECT_EQ(refined.task.parts, 1U);
  // Four lanes of 400 m from rest to rest, three turns where the yaw takes longest.
  EXPECT_NEAR(refined.cost, 4 * (40 + 5) + 3 * std::max(2 * std::sqrt(25 / 2.0), kPi), 1e-6);
  EXPECT_NEAR(refined.task.length, 4 * 400 + 3 * 25, 1e-9);
  EXPECT_EQ(refined.duration.expected.to_seconds(), refined.cost);
  for (const Vector3& point : refined.task.way) EXPECT_EQ(point.z(), 60);
}

TEST_F(CoverageTest, MinimumWidthTakesAsManyLanesAsTheWidthHasSwaths) {
  Random random(21);

  for (int i = 0; i < cases(10'000, 10'000); ++i) {
    CoverageQuery query = query_of(random_convex(random), random.uniform(15, 120));
    query.mode = SweepMode::kMinimumWidth;
    const double lanes = std::max(1.0, std::ceil(least_width(query.area) / query.swath));
    ASSERT_EQ(static_cast<double>(swept(query).task.lanes.size()), lanes) << "case " << i;
  }
}

TEST_F(CoverageTest, ConvexAreasAreCovered) {
  Random random(22);

  for (int i = 0; i < cases(150, 2000); ++i) {
    CoverageQuery query = query_of(random_convex(random), random.uniform(15, 120));
    query.mode = std::array{SweepMode::kLeastTime, SweepMode::kMinimumWidth,
                            SweepMode::kLongestLine, SweepMode::kGiven}[random.below(4)];
    query.direction = random.uniform(-9, 9);
    if (random.chance(0.5)) query.vehicle = fixed_wing();
    query.vehicle.energy.capacity = 1e12;
    ASSERT_GE(covered(query, swept(query).task), 0.9999) << "case " << i;
  }
}

TEST_F(CoverageTest, ConcaveAreasWithHolesAreCoveredInNoMoreTimeThanTheirHullTakes) {
  Random random(23);

  for (int i = 0; i < cases(60, 1000); ++i) {
    CoverageQuery query =
        query_of(random_star(random, 5 + random.below(15), 250, 500), random.uniform(20, 90));
    if (random.chance(0.7)) query.holes = {random_star(random, 3 + random.below(6), 40, 120)};
    if (random.chance(0.5)) query.vehicle = fixed_wing();
    query.vehicle.energy.capacity = 1e12;
    const auto refined = swept(query);
    ASSERT_GE(covered(query, refined.task), 0.999) << "case " << i;
    CoverageQuery hull = query_of(testing::wrapped_hull(query.area), query.swath);
    hull.vehicle = query.vehicle;
    ASSERT_LE(refined.cost, swept(hull).cost * 1.0001) << "case " << i;
  }
}

TEST_F(CoverageTest, LeastTimeIsWithinOnePercentOfTheBestOfEveryDegree) {
  Random random(24);

  for (int i = 0; i < cases(20, 500); ++i) {
    CoverageQuery query = query_of(random_convex(random), random.uniform(20, 90));
    if (random.chance(0.5)) query.vehicle = fixed_wing();
    query.vehicle.energy.capacity = 1e12;
    if (random.chance(0.5))
      query.start = Vector3(random.uniform(-800, 800), random.uniform(-800, 800), 60);
    if (random.chance(0.5))
      query.end = Vector3(random.uniform(-800, 800), random.uniform(-800, 800), 60);
    ASSERT_LE(swept(query).cost, 1.01 * best_of_every_degree(query)) << "case " << i;
  }
}

TEST_F(CoverageTest, LeastTimeIsNoSlowerThanAnIndependentSweepOfEveryDegree) {
  Random random(25);

  for (int i = 0; i < cases(5, 100); ++i) {
    const CoverageQuery query = query_of(random_convex(random), random.uniform(30, 90));
    double least = 1e300;
    for (int degree = 0; degree < 180; ++degree)
      least = std::min(least, own_sweep_time(query, degree * kPi / 180));
    ASSERT_LE(swept(query).cost, 1.001 * least) << "case " << i;
  }
}

TEST_F(CoverageTest, AGivenDirectionCostsWhatAnIndependentSweepCosts) {
  CoverageQuery query = query_of({{0, 0}, {300, -40}, {420, 180}, {100, 260}}, 37);
  query.mode = SweepMode::kGiven;

  for (const double direction : {0.0, 0.4, 1.3, 2.9}) {
    query.direction = direction;
    EXPECT_NEAR(swept(query).cost, own_sweep_time(query, direction), 3) << direction;
    EXPECT_NEAR(swept(query).task.direction, direction, 1e-12);
  }
}

TEST_F(CoverageTest, TheLongestLineOfAConvexAreaIsItsDiameter) {
  CoverageQuery query = query_of(rectangle(0, 0, 400, 300));
  query.mode = SweepMode::kLongestLine;

  const double direction = swept(query).task.direction;

  EXPECT_NEAR(std::abs(std::tan(direction)), 0.75, 1e-9);
}

TEST_F(CoverageTest, TheLongestLineOfAConcaveAreaStaysInside) {
  // An L: its hull's diameter is outside of it; the longest inside runs up the tall leg.
  CoverageQuery query = query_of({{0, 0}, {300, 0}, {300, 40}, {40, 40}, {40, 500}, {0, 500}}, 20);
  query.mode = SweepMode::kLongestLine;

  EXPECT_NEAR(swept(query).task.direction, kPi / 2 + std::atan2(40, 500), 0.09);
}

TEST_F(CoverageTest, ASwathWiderThanTheAreaTakesOneLane) {
  const auto refined = swept(query_of(rectangle(0, 0, 300, 20), 500));

  EXPECT_EQ(refined.task.lanes.size(), 1U);
  EXPECT_EQ(refined.task.turns, 0U);
}

TEST_F(CoverageTest, BeginsAtTheCornerNearTheStartAndEndsNearTheEnd) {
  CoverageQuery query = query_of(rectangle(-200, -100, 200, 100), 50);
  query.mode = SweepMode::kMinimumWidth;

  for (const Vector2& corner :
       {Vector2(-200, -100), Vector2(200, -100), Vector2(-200, 100), Vector2(200, 100)}) {
    query.start = Vector3(1.5 * corner.x(), 1.5 * corner.y(), 60);
    query.end.reset();
    const auto from = swept(query).task;
    EXPECT_EQ(from.way.front(), *query.start);
    EXPECT_LT((from.lanes.front().from - corner).norm(), 26);
    query.end = query.start;
    query.start.reset();
    const auto to = swept(query).task;
    EXPECT_EQ(to.way.back(), *query.end);
    EXPECT_LT((to.lanes.back().to - corner).norm(), 26);
  }
}

TEST_F(CoverageTest, TheWayOfOneThatCannotHoverIsFlyable) {
  Random random(26);

  for (int i = 0; i < cases(40, 400); ++i) {
    CoverageQuery query =
        query_of(i % 3 == 0 ? random_star(random, 9, 250, 500) : random_convex(random),
                 random.uniform(20, 150));
    query.vehicle = fixed_wing();
    query.vehicle.energy.capacity = 1e12;
    query.start =
        Vector3(random.uniform(-800, 800), random.uniform(-800, 800), random.uniform(0, 200));
    query.end =
        Vector3(random.uniform(-800, 800), random.uniform(-800, 800), random.uniform(0, 200));
    const auto refined = swept(query);
    ASSERT_TRUE(is_flyable(refined.task.way, query.vehicle, query.vehicle.cruise_speed, 0.5))
        << "case " << i;
    EXPECT_EQ(refined.task.way.front(), *query.start);
    EXPECT_EQ(refined.task.way.back(), *query.end);
  }
}

TEST_F(CoverageTest, LanesAreFlownOnTheWayInTheirOrder) {
  for (const auto& vehicle : {helicopter(), fixed_wing()}) {
    CoverageQuery query = query_of({{0, 0}, {300, -40}, {420, 180}, {100, 260}}, 37);
    query.vehicle = vehicle;
    const Coverage task = swept(query).task;

    std::size_t at = 0;
    for (const Lane& lane : task.lanes)
      for (const Vector2& end : {lane.from, lane.to}) {
        while (at < task.way.size() && (task.way[at].head<2>() - end).norm() > 1e-6) ++at;
        ASSERT_LT(at, task.way.size());
      }
  }
}

TEST_F(CoverageTest, SaysTheSameTwice) {
  CoverageQuery query = query_of(rectangle(0, 0, 400, 300));
  query.holes = {rectangle(150, 100, 250, 200)};
  query.start = Vector3(-50, -50, 0);

  const auto first = swept(query), second = swept(query);

  EXPECT_EQ(first.cost, second.cost);
  EXPECT_EQ(first.task.way, second.task.way);
  EXPECT_EQ(first.effort, second.effort);
}

TEST_F(CoverageTest, AnEmptyBudgetStillGivesASweepThatCovers) {
  CoverageQuery query = query_of(rectangle(0, 0, 400, 300));
  setting_.budget.steps = 0;

  EXPECT_GE(covered(query, swept(query).task), 0.9999);
}

TEST_F(CoverageTest, AClockThatIsUpCutsTheSearchAndItSaysSo) {
  CoverageQuery query = query_of(rectangle(0, 0, 400, 300));
  setting_.budget.time_is_up = [] { return true; };

  const auto refined = swept(query);

  EXPECT_TRUE(refined.effort.cut_short);
  EXPECT_LT(refined.effort.steps, 20U);
  EXPECT_GE(covered(query, refined.task), 0.9999);
}

TEST_F(CoverageTest, HolesThatLeaveNothingAreRefused) {
  CoverageQuery query = query_of(rectangle(0, 0, 400, 300));
  query.holes = {query.area};
  const auto whole = refine(query, setting_);
  query.holes = {rectangle(0, 0, 400, 150), rectangle(0, 150, 400, 300)};
  const auto halves = refine(query, setting_);
  query.holes = {rectangle(0, 0, 400, 299)};
  const auto nearly = refine(query, setting_);

  ASSERT_FALSE(whole || halves);
  EXPECT_EQ(whole.error().kind, RefusalKind::kBadQuery);
  EXPECT_EQ(whole.error().field, "holes");
  EXPECT_EQ(whole.error().why, "they leave nothing of the area to be swept");
  EXPECT_TRUE(nearly);
}

TEST_F(CoverageTest, AnAreaOutsideTheWorldIsRefusedWithHowFar) {
  const auto beyond = refine(query_of(rectangle(1e6, 0, 1e6 + 400, 300)), setting_);
  const auto across = refine(query_of(rectangle(900, 0, 1300, 300)), setting_);

  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().kind, RefusalKind::kBadQuery);
  EXPECT_EQ(beyond.error().field, "area");
  EXPECT_NE(beyond.error().why.find("outside the world, by 9.99e+05 m"), std::string::npos)
      << beyond.error().why;
  EXPECT_TRUE(across);
}

TEST_F(CoverageTest, TheSenseOfTheCornersDoesNotMatter) {
  CoverageQuery query = query_of({{0, 0}, {300, -40}, {420, 180}, {100, 260}});
  const double cost = swept(query).cost;
  std::reverse(query.area.begin(), query.area.end());

  EXPECT_NEAR(swept(query).cost, cost, 1e-6);
}

}  // namespace
}  // namespace skein::refiners
