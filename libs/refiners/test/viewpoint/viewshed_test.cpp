// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/viewshed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "skein/foundation/random.hpp"
#include "skein/world/viewshed.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

/// Random hills, 20 m cells, 1 km square.
world::World hilly(std::uint64_t seed) {
  Random random(seed);
  world::TerrainSpec spec;
  spec.west = spec.south = 0;
  spec.east = spec.north = 1000;
  for (int i = 0; i < 8; ++i)
    spec.hills.push_back({{random.uniform(0, 1000), random.uniform(0, 1000)},
                          random.uniform(30, 150),
                          random.uniform(80, 300)});
  world::World world = testing::level_world();
  world.terrain = world::Terrain(spec);
  return world;
}

/// By steps of a metre along the line, knowing nothing of cells.
bool sees_by_steps(const world::Terrain& terrain, const Vector3& a, const Vector3& b) {
  const double length = (b - a).norm();
  for (double along = 1; along < length - 1; along += 1) {
    const Vector3 at = a + along / length * (b - a);
    if (at.z() < terrain.elevation(at.x(), at.y())) return false;
  }
  return true;
}

ViewshedQuery from_over(const world::World& world, double x, double y, double height) {
  ViewshedQuery query;
  query.from = {x, y, world.terrain.elevation(x, y) + height};
  query.height = 2;
  return query;
}

TEST(ViewshedService, SaysOfEachCellWhatAWalkAlongTheLineOfSightSays) {
  std::size_t differ = 0, cells = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const world::World world = hilly(seed);
    const ViewshedQuery query = from_over(world, 480, 510, 20);

    const auto answer = refine(query, Setting{.world = world, .budget = {}});

    ASSERT_TRUE(answer) << answer.error().why;
    ASSERT_EQ(answer->task.grid.size(), 2500U);
    std::size_t seen = 0;
    for (std::size_t cell = 0; cell < answer->task.grid.size(); ++cell) {
      const Vector2 at = answer->task.grid.centre(cell);
      const Vector3 target(at.x(), at.y(), world.terrain.elevation(at.x(), at.y()) + 2);
      const bool expected = sees_by_steps(world.terrain, query.from, target);
      differ += expected != (answer->task.cells[cell] == Sight::kSeen) ? 1 : 0;
      seen += answer->task.cells[cell] == Sight::kSeen ? 1 : 0;
    }
    cells += answer->task.asked;
    EXPECT_EQ(answer->task.seen, seen);
    EXPECT_NEAR(answer->cost, 1 - static_cast<double>(seen) / 2500, 1e-12);
    EXPECT_GT(seen, 200U);
    EXPECT_LT(seen, 2400U);
  }
  EXPECT_LE(1000 * differ, cells) << "steps of a metre miss what barely stands in between";
}

TEST(ViewshedService, AsksOnlyForTheAreaAndWithinRange) {
  const world::World world = hilly(1);
  ViewshedQuery query = from_over(world, 500, 500, 300);
  query.area = {{200, 200}, {800, 200}, {800, 800}};
  query.range = 400;
  query.cell = 30;

  const auto answer = refine(query, Setting{.world = world, .budget = {}});

  ASSERT_TRUE(answer) << answer.error().why;
  const Viewshed& view = answer->task;
  EXPECT_EQ(view.grid, (world::Grid{200, 200, 30, 20, 20}));
  for (std::size_t cell = 0; cell < view.grid.size(); ++cell) {
    const Vector2 at = view.grid.centre(cell);
    EXPECT_EQ(view.cells[cell] == Sight::kLeftOut, !world::contains(query.area, at));
    if (view.cells[cell] != Sight::kSeen) continue;
    EXPECT_LE((at - query.from.head<2>()).norm(), 400);
  }
  EXPECT_GT(view.seen, 0U);
}

TEST(ViewshedService, RefusesWhatMakesNoSense) {
  const world::World world = hilly(2);
  const auto refusal = [&](const std::function<void(ViewshedQuery&)>& change) {
    ViewshedQuery query = from_over(world, 500, 500, 10);
    change(query);
    const auto answer = refine(query, Setting{.world = world, .budget = {}});
    return answer ? Refusal{} : answer.error();
  };

  EXPECT_EQ(refusal([](auto& q) { q.from.x() = NAN; }).field, "from");
  EXPECT_EQ(refusal([](auto& q) { q.from.z() -= 20; }).kind, RefusalKind::kBlocked);
  EXPECT_EQ(refusal([](auto& q) { q.height = -1; }).field, "height");
  EXPECT_EQ(refusal([](auto& q) { q.range = 0; }).field, "range");
  EXPECT_EQ(refusal([](auto& q) { q.cell = 0.1; }).field, "cell");
  EXPECT_EQ(refusal([](auto& q) { q.area = {{0, 0}, {1, 1}}; }).field, "area");
  EXPECT_EQ(refusal([](auto& q) { q.area = {{1, 1}, {2, 1}, {2, 2}}; }).field, "area");
  EXPECT_EQ(refusal([](auto& q) { q.area = {{9e6, 0}, {9.1e6, 0}, {9e6, 9e4}}; }).field, "area");
}

TEST(ViewshedService, SaysThatItWasNotDoneInTime) {
  const world::World world = hilly(3);
  const ViewshedQuery query = from_over(world, 500, 500, 10);

  const auto late = refine(query, Setting{.world = world, .budget = {[] { return true; }}});
  const auto few =
      refine(query, Setting{.world = world, .budget = {.time_is_up = {}, .steps = 100}});

  ASSERT_FALSE(late || few);
  EXPECT_EQ(late.error().kind, RefusalKind::kBudgetExhausted);
  EXPECT_EQ(few.error().kind, RefusalKind::kBudgetExhausted);
}

}  // namespace
}  // namespace skein::refiners
