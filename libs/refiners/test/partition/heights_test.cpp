// SPDX-License-Identifier: Apache-2.0
// Neighbours do not meet over their common border.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "test_cases.hpp"
#include "testing/builders.hpp"
#include "testing/partition_cases.hpp"

namespace skein::refiners {
namespace {

using testing::fixed_wing;
using testing::helicopter;
using world::Vector2;
using world::Vector3;

/// Every three metres from the first lane to the last.
std::vector<Vector3> places_of_sweep(const Coverage& coverage) {
  const auto is = [](const Vector3& point, const Vector2& place) {
    return (point.head<2>() - place).norm() < 1e-6;
  };
  std::size_t first = 0, last = coverage.way.size() - 1;
  while (!is(coverage.way[first], coverage.lanes.front().from)) ++first;
  while (!is(coverage.way[last], coverage.lanes.back().to)) --last;
  std::vector<Vector3> places;
  for (std::size_t i = first; i < last; ++i) {
    const Vector3 leg = coverage.way[i + 1] - coverage.way[i];
    const double count = std::max(1.0, std::ceil(leg.head<2>().norm() / 3));
    for (double k = 0; k <= count; ++k) places.push_back(coverage.way[i] + leg * (k / count));
  }
  return places;
}

/// The least difference in height where they are closer than `apart` on the level.
double least_height_between(const Coverage& a, const Coverage& b, double apart) {
  std::vector<Vector3> others = places_of_sweep(b);
  std::sort(others.begin(), others.end(),
            [](const Vector3& p, const Vector3& q) { return p.x() < q.x(); });
  double least = 1e18;
  for (const Vector3& at : places_of_sweep(a)) {
    auto other = std::lower_bound(others.begin(), others.end(), at.x() - apart,
                                  [](const Vector3& p, double x) { return p.x() < x; });
    for (; other != others.end() && other->x() < at.x() + apart; ++other)
      if ((other->head<2>() - at.head<2>()).norm() < apart)
        least = std::min(least, std::abs(other->z() - at.z()));
  }
  return least;
}

PartitionQuery a_query(Random& random) {
  PartitionQuery query;
  query.area = testing::random_convex(random, random.uniform(250, 500), 12);
  const auto members = 2 + random.below(3);
  for (std::size_t i = 0; i < members; ++i) {
    Member member;
    member.uav = "uav-" + std::to_string(i);
    member.vehicle = random.chance(0.5) ? helicopter() : fixed_wing();
    member.start = testing::on_border(random, query.area);
    member.swath = random.uniform(40, 80);
    member.altitude = random.chance(0.7) ? 60 : random.uniform(40, 90);
    query.members.push_back(member);
  }
  query.mode = random.chance(0.3) ? ShareMode::kBalanced : ShareMode::kProportional;
  return query;
}

world::World a_world(Random& random) {
  world::World world = testing::level_world();
  if (random.chance(0.5)) return world;
  world::TerrainSpec spec;
  spec.west = spec.south = -1000;
  spec.east = spec.north = 1000;
  for (int i = 0; i < 5; ++i)
    spec.hills.push_back({{random.uniform(-500, 500), random.uniform(-500, 500)},
                          random.uniform(20, 80),
                          random.uniform(200, 400)});
  world.terrain = world::Terrain(spec);
  return world;
}

TEST(Partition, SweepsThatMeetOnTheLevelAreApartInHeight) {
  Random random(8);
  int met = 0, raised = 0;
  for (int i = 0; i < skein::testing::cases<int>(6, 200); ++i) {
    SCOPED_TRACE(i);
    const world::World world = a_world(random);
    PartitionQuery query = a_query(random);
    const Setting setting{.world = world, .budget = {}};

    const auto answer = refine(query, setting);
    query.apart = 0;
    const auto careless = refine(query, setting);

    ASSERT_TRUE(answer) << answer.error().why;
    ASSERT_TRUE(careless) << careless.error().why;
    const auto& parts = answer->task.parts;
    for (std::size_t a = 0; a < parts.size(); ++a) {
      EXPECT_GE(parts[a].altitude, query.members[a].altitude);
      raised += parts[a].altitude > query.members[a].altitude ? 1 : 0;
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_GE(least_height_between(parts[a].coverage, parts[b].coverage, 10), 10 - 1e-6)
            << parts[a].uav << " and " << parts[b].uav;
        met += least_height_between(careless->task.parts[a].coverage,
                                    careless->task.parts[b].coverage, 10) < 10
                   ? 1
                   : 0;
      }
    }
  }
  EXPECT_GT(met, 3) << "without asking they meet";
  EXPECT_GT(raised, 3);
}

TEST(Partition, SaysWhoCannotBeRaised) {
  const world::World world = testing::level_world();
  PartitionQuery query;
  query.area = {{0, 0}, {400, 0}, {400, 100}, {0, 100}};
  for (const char* name : {"west", "east"}) {
    Member member;
    member.uav = name;
    member.vehicle = helicopter();
    member.vehicle.ceiling = 65;
    member.start = {name == std::string("west") ? 0.0 : 400.0, 0};
    member.swath = 50;
    member.altitude = 60;
    query.members.push_back(member);
  }

  const auto refused = refine(query, Setting{.world = world, .budget = {}});
  query.apart = NAN;
  const auto wrong = refine(query, Setting{.world = world, .budget = {}});
  query.apart = 5;
  const auto closer = refine(query, Setting{.world = world, .budget = {}});

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, RefusalKind::kBeyondVehicle);
  EXPECT_NE(refused.error().why.find("within 10 m of"), std::string::npos);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().field, "apart");
  EXPECT_TRUE(closer) << closer.error().why;
}

TEST(Partition, SaysWhenTheTimeWasUpBeforeHeightsWereSettled) {
  Random random(5);
  const world::World world = testing::level_world();
  const PartitionQuery query = a_query(random);
  const Budget none{.time_is_up = [] { return true; }};

  const auto hurried = refine(query, Setting{.world = world, .budget = none});
  const auto settled = refine(query, Setting{.world = world, .budget = {}});

  ASSERT_TRUE(hurried && settled);
  EXPECT_FALSE(hurried->task.apart);
  EXPECT_TRUE(hurried->effort.cut_short);
  EXPECT_TRUE(settled->task.apart);
}

}  // namespace
}  // namespace skein::refiners
