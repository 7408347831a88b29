// SPDX-License-Identifier: Apache-2.0
// The ways of the voxels, judged by FCL; and both planners on the same queries.
#include <gtest/gtest.h>

#include <cstdlib>

#include "skein/refiners/voxel_path_planner.hpp"
#include "skein/sampling/collision_scene.hpp"
#include "skein/sampling/sampling_path_planner.hpp"
#include "worlds.hpp"

namespace skein::sampling {
namespace {

using refiners::PathQuery;
using refiners::Setting;
using world::Vector3;

int cases(int few, int many) { return std::getenv("SKEIN_FULL") ? many : few; }

world::World random_world(Random& random) {
  world::World world = hills(random);
  for (int k = 0; k < 8; ++k) world.volumes.push_back(a_star(random, std::to_string(k)));
  return world;
}

PathQuery random_query(Random& random, const world::World& world) {
  PathQuery query;
  query.vehicle = random.chance(0.5) ? a_helicopter() : a_blimp();
  query.clearance = random.uniform(0, 15);
  const auto at = [&](double x) {
    const double y = random.uniform(50, 950);
    return Vector3(x, y, std::min(195.0, world.terrain.elevation(x, y) + random.uniform(25, 60)));
  };
  query.from = at(random.uniform(50, 200));
  query.to = at(random.uniform(800, 950));
  return query;
}

TEST(VoxelTracks, NeverMeetAnythingByFcl) {
  Random random(1);
  int found = 0;
  const int count = cases(12, 500);
  for (int i = 0; i < count; ++i) {
    const world::World world = random_world(random);
    const PathQuery query = random_query(random, world);

    const auto path =
        refiners::VoxelPathPlanner().plan(query, Setting{.world = world, .budget = {}});

    if (!path) continue;
    ++found;
    const CollisionScene scene(world, {.clearance = query.clearance, .ground_accuracy = 0.05});
    const auto& way = path->task.way;
    // A hair less: ways may touch what the voxels leave free.
    const double radius = query.vehicle.body_radius - 0.06;
    for (std::size_t k = 1; k < way.size(); ++k) {
      const auto conflict = scene.first_conflict(way[k - 1], way[k], radius);
      ASSERT_FALSE(conflict.has_value())
          << conflict->with << " on leg " << k << " of case " << i << ", from "
          << way[k - 1].transpose() << " to " << way[k].transpose();
    }
  }
  RecordProperty("found", found);
  EXPECT_GE(found, count / 4);
}

TEST(BothPlanners, AgreeOnWhatIsEasyAndOnAboutHowLongItIs) {
  Random random(2);
  int both = 0;
  for (int i = 0; i < cases(6, 60); ++i) {
    const world::World world = hills(random, 6);
    PathQuery query = random_query(random, world);
    query.vehicle = a_helicopter();
    const Setting setting{.world = world, .budget = {}};

    const auto voxels = refiners::VoxelPathPlanner().plan(query, setting);
    const auto sampled = SamplingPathPlanner().plan(query, setting);

    if (!voxels || !sampled) continue;
    ++both;
    EXPECT_LE(sampled->task.length, 1.1 * voxels->task.length);
    EXPECT_LE(voxels->task.length, 1.1 * sampled->task.length);
  }
  EXPECT_GE(both, 3);
}

TEST(BothPlanners, FindNoWayThroughAClosedWall) {
  world::World world = a_plain();
  world.volumes = {a_box("wall", {480, -10}, {520, 1010}, -10, 300)};
  PathQuery query;
  query.vehicle = a_helicopter();
  query.from = {100, 100, 55};
  query.to = {900, 100, 55};
  const Setting setting{.world = world, .budget = {.time_is_up = {}, .steps = 2'000'000}};
  const Setting few{.world = world, .budget = {.time_is_up = {}, .steps = 200}};

  const auto voxels = refiners::VoxelPathPlanner().plan(query, setting);
  const auto sampled = SamplingPathPlanner().plan(query, few);

  ASSERT_FALSE(voxels.has_value());
  ASSERT_FALSE(sampled.has_value());
  EXPECT_EQ(voxels.error().kind, refiners::RefusalKind::kUnreachable);
  EXPECT_EQ(sampled.error().kind, refiners::RefusalKind::kBudgetExhausted);
}

}  // namespace
}  // namespace skein::sampling
