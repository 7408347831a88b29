// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "skein/foundation/random.hpp"
#include "skein/refiners/evaluate.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::helicopter;
using testing::level_world;
using world::Vector3;

InsertionQuery random_query(Random& random) {
  const auto place = [&] {
    return Vector3(random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(40, 150));
  };
  InsertionQuery query;
  query.vehicle = helicopter();
  query.start = place();
  for (std::uint64_t i = random.below(6); i > 0; --i)
    query.plan.push_back({place(), place(), Duration::seconds(random.uniform(0, 50))});
  query.task = {place(), place(), Duration::seconds(30)};
  if (random.chance(0.5)) query.end = place();
  return query;
}

/// All of a plan, flown.
double seconds_of(const InsertionQuery& query, const std::vector<PlannedTask>& plan) {
  double seconds = 0;
  Vector3 at = query.start;
  const auto fly = [&](const Vector3& to) {
    seconds += estimate_flight({at, to}, query.vehicle, {}).duration.expected.to_seconds();
  };
  for (const PlannedTask& task : plan) {
    fly(task.from);
    seconds += task.duration.to_seconds();
    at = task.to;
  }
  if (query.end) fly(*query.end);
  return seconds;
}

TEST(Insertion, AddsWhatTheWholePlanTakesLonger) {
  const world::World world = level_world();
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const InsertionQuery query = random_query(random);

    const auto found = refine(query, {.world = world, .budget = {}});

    ASSERT_TRUE(found) << found.error().why;
    ASSERT_EQ(found->task.added.size(), query.plan.size() + 1);
    const double before = seconds_of(query, query.plan);
    for (std::size_t at = 0; at <= query.plan.size(); ++at) {
      std::vector<PlannedTask> plan = query.plan;
      plan.insert(plan.begin() + static_cast<std::ptrdiff_t>(at), query.task);
      EXPECT_NEAR(found->task.added[at], seconds_of(query, plan) - before, 1e-6);
    }
    const auto best = std::min_element(found->task.added.begin(), found->task.added.end());
    EXPECT_EQ(found->cost, *best);
    EXPECT_EQ(found->task.position, static_cast<std::size_t>(best - found->task.added.begin()));
    EXPECT_EQ(found->task.to.back(), query.task.from);
    EXPECT_LE(found->duration.least, found->duration.expected);
    EXPECT_LE(found->duration.expected, found->duration.most);
  }
}

TEST(Insertion, IntoAnEmptyPlanIsTheTaskAndTheWayThere) {
  const world::World world = level_world();
  InsertionQuery query;
  query.vehicle = helicopter();
  query.start = {0, 0, 50};
  query.task = {{100, 0, 50}, {200, 0, 50}, Duration::seconds(30)};

  const auto found = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(found);
  EXPECT_NEAR(found->cost, 40, 1e-6);
  EXPECT_TRUE(found->task.from.empty());
}

/// Nothing that is not straight.
class NoPlanner final : public PathPlanner {
 public:
  Outcome<Path> plan(const PathQuery&, const Setting&) const override {
    return refuse(RefusalKind::kUnreachable, "to", "closed");
  }
};

TEST(Insertion, IsRefusedWhenNoPlaceHasAWay) {
  world::World world = level_world();
  world::Volume wall;
  wall.polygon = {{290, -1000}, {310, -1000}, {310, 1000}, {290, 1000}};
  world.volumes.push_back(wall);
  InsertionQuery query;
  query.vehicle = helicopter();
  query.start = {0, 0, 50};
  query.task = {{500, 0, 50}, {500, 0, 50}, Duration::seconds(30)};
  const NoPlanner none;

  const auto task = refine(query, {.world = world, .budget = {}, .paths = &none});
  query.plan = {query.task};
  const auto plan = refine(query, {.world = world, .budget = {}, .paths = &none});

  ASSERT_FALSE(task || plan);
  EXPECT_EQ(task.error().kind, RefusalKind::kUnreachable);
  EXPECT_EQ(task.error().field, "task");
  EXPECT_EQ(plan.error().field, "plan.0.from");
}

/// A wall through the whole air but for a gap in the north.
world::World walled_world() {
  world::World world = level_world();
  world::Volume wall;
  wall.polygon = {{-10, -1000}, {10, -1000}, {10, 900}, {-10, 900}};
  world.volumes.push_back(wall);
  return world;
}

/// To and fro across the wall, with places at the centres of voxels.
InsertionQuery query_across(int tasks) {
  InsertionQuery query;
  query.vehicle = helicopter();
  query.start = {-850, -850, 30};
  query.end = query.start;
  for (int i = 0; i < tasks; ++i) {
    const world::Vector3 at(i % 2 == 0 ? 510 : -510, -800 + 60 * i, 50);
    query.plan.push_back({at, at, Duration::seconds(10)});
  }
  query.task = {{-510, 310, 50}, {-490, 310, 50}, Duration::seconds(30)};
  return query;
}

/// Around the wall by the north; counts, and asks the clock as a search does.
class DetourPlanner final : public PathPlanner {
 public:
  Outcome<Path> plan(const PathQuery& query, const Setting& setting) const override {
    ++asked;
    if (setting.budget.expired()) return refuse(RefusalKind::kBudgetExhausted, "", "late");
    Refined<Path> path;
    path.task.way = {query.from, {0, 950, 50}, query.to};
    return path;
  }
  mutable int asked = 0;
};

TEST(Insertion, LooksForAtMostThreeWaysAPosition) {
  const world::World world = walled_world();
  const InsertionQuery query = query_across(20);
  const DetourPlanner planner;

  const auto found = refine(query, {.world = world, .budget = {}, .paths = &planner});

  ASSERT_TRUE(found);
  EXPECT_GT(planner.asked, 10);
  EXPECT_LE(planner.asked, 3 * 21);
}

TEST(Insertion, RepeatsNoPointInSuccession) {
  const world::World world = walled_world();
  InsertionQuery query = query_across(1);
  query.task = {{490, 310, 50}, {510, 310, 50}, Duration::seconds(30)};

  const auto found = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(found);
  for (const Way& way : {found->task.to, found->task.from}) {
    ASSERT_GE(way.size(), 2U);
    for (std::size_t i = 1; i < way.size(); ++i) EXPECT_NE(way[i - 1], way[i]);
  }
}

TEST(Insertion, GivesTheBestPositionTriedWhenTheTimeIsUp) {
  const world::World world = walled_world();
  const InsertionQuery query = query_across(12);
  const DetourPlanner planner;
  Setting setting{.world = world, .budget = {}, .paths = &planner};
  const auto whole = refine(query, setting);
  ASSERT_TRUE(whole);
  int none = 0, some = 0;
  for (int asks = 0; asks < 100; ++asks) {
    SCOPED_TRACE(asks);
    int asked = 0;
    setting.budget.time_is_up = [&] { return ++asked > asks; };

    const auto found = refine(query, setting);

    if (!found) {
      EXPECT_EQ(found.error().kind, RefusalKind::kBudgetExhausted);
      ++none;
      continue;
    }
    const auto& added = found->task.added;
    EXPECT_EQ(found->cost, *std::min_element(added.begin(), added.end()));
    if (found->effort.cut_short) ++some;
    if (!found->effort.cut_short) {
      EXPECT_EQ(added, whole->task.added);
    }
  }
  EXPECT_GT(none, 0);
  EXPECT_GT(some, 0);
}

TEST(Insertion, RefusesFiguresThatMakeNoSenseByTheirFields) {
  const world::World world = level_world();
  Random random(3);
  const auto field_of = [&](auto spoil) {
    InsertionQuery query = random_query(random);
    query.plan = {query.task, query.task};
    spoil(query);
    const auto found = refine(query, {.world = world, .budget = {}});
    return found ? "none" : found.error().field;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_EQ(field_of([&](InsertionQuery& q) { q.start.x() = nan; }), "start");
  EXPECT_EQ(field_of([&](InsertionQuery& q) { q.plan[1].to.x() = nan; }), "plan.1.to");
  EXPECT_EQ(field_of([&](InsertionQuery& q) { q.task.from.x() = nan; }), "task.from");
  EXPECT_EQ(field_of([](InsertionQuery& q) { q.task.duration = Duration::seconds(-1); }),
            "task.duration");
}

}  // namespace
}  // namespace skein::refiners
