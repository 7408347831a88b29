// SPDX-License-Identifier: Apache-2.0
// A budget holds: whatever the ground, a way is asked for ends soon after its processor time; and
// as long as there is time it is looked for.
#include <gtest/gtest.h>

#include <cmath>

#include "processor_time.hpp"
#include "skein/sampling/sampling_path_planner.hpp"
#include "worlds.hpp"

namespace skein::sampling {
namespace {

using refiners::PathQuery;
using refiners::RefusalKind;
using refiners::Setting;

using skein::testing::kRoom;
using skein::testing::processor_seconds;

/// Rough ground of so many posts along a side of a kilometre; its cells have to be cut finer.
world::World rough(std::size_t posts) {
  world::TerrainSpec terrain;
  terrain.east = terrain.north = 1000;
  terrain.cell = 1000 / static_cast<double>(posts);
  const auto corners = world::corners_of(terrain);
  Random random(posts);
  for (std::size_t i = 0; i < corners.count(); ++i)
    terrain.elevations.push_back(30 * random.uniform() +
                                 20 * std::sin(static_cast<double>(i) / 40));
  world::World world = a_plain();
  world.terrain = world::Terrain(terrain);
  return world;
}

PathQuery across(const world::VehicleModel& vehicle) {
  PathQuery query;
  query.vehicle = vehicle;
  query.clearance = 5;
  query.from = {20, 20, 70};
  query.to = {980, 980, 70};
  return query;
}

TEST(BudgetLaw, WaysOverAnyGroundAreAnsweredInTime) {
  for (const std::size_t posts : {100UL, 400UL, 1000UL})
    for (const bool walled : {false, true})
      for (const auto& vehicle : {a_helicopter(), a_blimp()})
        for (const double budget : {0.0, 0.02, 0.15}) {
          auto world = rough(posts);
          if (walled) world.volumes = {a_box("wall", {480, 0}, {520, 1000}, -10, 300)};
          const auto query = across(vehicle);
          double late = 1e9;
          for (int i = 0; i < 8 && late > kRoom; ++i) {
            const double began = processor_seconds();
            Setting setting{.world = world, .budget = {}};
            setting.budget.time_is_up = [&] { return processor_seconds() - began > budget; };

            const auto path = SamplingPathPlanner().plan(query, setting);

            late = std::min(late, skein::testing::late_here(processor_seconds() - began - budget));
            const bool in_time = path || path.error().kind == RefusalKind::kBudgetExhausted;
            EXPECT_TRUE(in_time || walled || !vehicle.hovers) << path.error().why;
          }
          EXPECT_LT(late, kRoom) << posts << " posts, " << vehicle.name << ", " << budget << " s"
                                 << (walled ? ", walled" : "");
        }
}

TEST(BudgetLaw, AWayIsLookedForAsLongAsThereIsTime) {
  auto world = a_plain();
  world.volumes = {a_box("wall", {480, 0}, {520, 1000}, -10, 300)};
  std::uint64_t asked = 0;
  Setting setting{.world = world, .budget = {}};
  setting.budget.time_is_up = [&] { return ++asked > 30'000; };

  const auto path =
      SamplingPathPlanner({.first_samples = 100}).plan(across(a_helicopter()), setting);

  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().kind, RefusalKind::kBudgetExhausted);
  EXPECT_GT(asked, 30'000U) << "it gave up before: " << path.error().why;
}

}  // namespace
}  // namespace skein::sampling
