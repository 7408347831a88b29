// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_headland.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/world/segment.hpp"
#include "test_cases.hpp"
#include "testing/builders.hpp"
#include "testing/partition_cases.hpp"

namespace skein::refiners {
namespace {

using testing::fixed_wing;
using testing::helicopter;
using testing::random_convex;
using world::Polygon;
using world::Vector2;
using world::Vector3;

double to_border(const Polygon& area, const Vector2& at) {
  double least = 1e18;
  for (std::size_t i = 0; i < area.size(); ++i)
    least = std::min(least, world::to_segment(at, area[i], area[(i + 1) % area.size()]));
  return least;
}

bool is_within(const Polygon& area, const Vector2& at) {
  return world::contains(area, at) || to_border(area, at) < 1e-3;
}

/// Within half a swath of a lane, and beside it.
bool is_swept(const Coverage& coverage, double swath, const Vector2& at) {
  return std::any_of(coverage.lanes.begin(), coverage.lanes.end(), [&](const Lane& lane) {
    const Vector2 along = lane.to - lane.from, offset = at - lane.from;
    const double length = along.norm();
    if (length == 0) return offset.norm() <= swath / 2;
    const double part = offset.dot(along) / length;
    const double aside = std::abs(along.x() * offset.y() - along.y() * offset.x()) / length;
    return part >= -1e-6 && part <= length + 1e-6 && aside <= swath / 2 + 1e-6;
  });
}

/// The corner nearest to a place is sharper than a right angle, and nearer than that.
bool is_at_a_tip(const Polygon& area, const Vector2& at, double distance) {
  const std::size_t n = area.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 in = area[i] - area[(i + n - 1) % n], out = area[(i + 1) % n] - area[i];
    if (in.dot(out) < 1e-9 && (at - area[i]).norm() < distance) return true;
  }
  return false;
}

/// Every two metres from the first lane to the last, by the corners of the way.
std::vector<Vector2> places_of_sweep(const Coverage& coverage) {
  const auto is = [](const Vector3& point, const Vector2& place) {
    return (point.head<2>() - place).norm() < 1e-6;
  };
  std::size_t first = 0, last = coverage.way.size() - 1;
  while (!is(coverage.way[first], coverage.lanes.front().from)) ++first;
  while (!is(coverage.way[last], coverage.lanes.back().to)) --last;
  std::vector<Vector2> places;
  for (std::size_t i = first; i < last; ++i) {
    const Vector2 a = coverage.way[i].head<2>(), b = coverage.way[i + 1].head<2>();
    const double count = std::ceil((b - a).norm() / 2);
    for (double k = 0; k <= count; ++k)
      places.emplace_back(a + (b - a) * (k / std::max(1.0, count)));
  }
  return places;
}

CoverageQuery over(const Polygon& area, const world::VehicleModel& vehicle) {
  CoverageQuery query;
  query.vehicle = vehicle;
  query.vehicle.energy.capacity *= 100;
  query.area = area;
  query.swath = 30;
  query.altitude = 50;
  query.start = Vector3(-900, -900, 60);
  query.turns_inside = true;
  return query;
}

TEST(TurnsInside, NothingBetweenTheFirstLaneAndTheLastLeavesTheAreaAndAllButTheHeadlandIsSwept) {
  const world::World world = testing::level_world();
  Random random(13);
  int swept = 0;
  for (int i = 0; i < skein::testing::cases<int>(24, 400); ++i) {
    const Polygon area = random_convex(random, random.uniform(150, 600), 12);
    const CoverageQuery query = over(area, random.chance(0.5) ? helicopter() : fixed_wing());
    SCOPED_TRACE(i);

    const auto answer = refine(query, Setting{.world = world, .budget = {}});

    if (!answer) {
      EXPECT_EQ(answer.error().field, "turns_inside") << answer.error().why;
      continue;
    }
    ++swept;
    const Coverage& coverage = answer->task;
    for (const Vector2& at : places_of_sweep(coverage))
      ASSERT_TRUE(is_within(area, at)) << at.transpose();
    const bool hovers = query.vehicle.hovers;
    EXPECT_EQ(hovers, coverage.left_out == 0);
    double left = 0, all = 0;
    for (double x = -600; x < 600; x += 12)
      for (double y = -600; y < 600; y += 12) {
        const Vector2 at(x, y);
        if (!world::contains(area, at)) continue;
        const bool asked = hovers ? !is_at_a_tip(area, at, query.swath)
                                  : to_border(area, at) > coverage.headland + 1e-6;
        ++all;
        left += to_border(area, at) > coverage.headland ? 0 : 1;
        ASSERT_TRUE(!asked || is_swept(coverage, query.swath, at)) << at.transpose();
      }
    if (!hovers && all > 500) {
      EXPECT_NEAR(coverage.left_out, left / all, 0.05);
    }
  }
  EXPECT_GE(2 * swept, skein::testing::cases<int>(24, 400));
}

TEST(TurnsInside, TakesLongerThanTurnsAnywhere) {
  const world::World world = testing::level_world();
  CoverageQuery query = over({{0, 0}, {600, 0}, {600, 400}, {0, 400}}, helicopter());

  const auto inside = refine(query, Setting{.world = world, .budget = {}});
  query.turns_inside = false;
  const auto anywhere = refine(query, Setting{.world = world, .budget = {}});

  ASSERT_TRUE(inside && anywhere);
  EXPECT_GT(inside->cost, anywhere->cost);
  EXPECT_LT(inside->cost, 1.3 * anywhere->cost);
  EXPECT_EQ(anywhere->task.headland, 0);
  EXPECT_EQ(inside->task.headland, query.swath);
}

TEST(TurnsInside, AreRefusedWhereThereIsNoRoomForThem) {
  const world::World world = testing::level_world();
  const auto refusal = [&](CoverageQuery query) {
    const auto answer = refine(query, Setting{.world = world, .budget = {}});
    return answer ? Refusal{} : answer.error();
  };
  const Polygon narrow = {{0, 0}, {400, 0}, {400, 50}, {0, 50}};
  CoverageQuery holed = over({{0, 0}, {400, 0}, {400, 400}, {0, 400}}, helicopter());
  holed.holes = {{{10, 100}, {80, 100}, {80, 200}}};

  EXPECT_EQ(refusal(over(narrow, fixed_wing())).field, "turns_inside");
  EXPECT_EQ(refusal(over({{0, 0}, {400, 0}, {200, 100}, {400, 400}}, helicopter())).kind,
            RefusalKind::kBadQuery);
  EXPECT_EQ(refusal(holed).field, "holes.0");
}

TEST(WithoutHeadland, IsWhatIsThatFarFromTheBorder) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Polygon area = random_convex(random, 300, 10);
    const double width = random.uniform(1, 150);

    const Polygon inner = without_headland(area, width);

    for (int k = 0; k < 200; ++k) {
      const Vector2 at(random.uniform(-300, 300), random.uniform(-300, 300));
      const double border = to_border(area, at);
      if (std::abs(border - width) < 1e-6) continue;
      const bool expected = world::contains(area, at) && border > width;
      EXPECT_EQ(inner.size() > 2 && world::contains(inner, at), expected);
    }
  }
}

}  // namespace
}  // namespace skein::refiners
