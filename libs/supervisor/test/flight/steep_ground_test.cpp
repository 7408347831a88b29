// SPDX-License-Identifier: Apache-2.0
// Ways over steep ground of a vehicle that cannot hover, as it flies them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flight/autopilot.hpp"
#include "flight/flights_met.hpp"
#include "skein/foundation/random.hpp"
#include "skein/supervisor/own_ways.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor::testing {
namespace {

using namespace std::string_literals;
using world::Vector3;

/// Karma in flight among hills that are steeper than it climbs.
PlanningLab among_hills(std::uint64_t seed) {
  PlanningLab lab;
  lab.vehicle(vehicle_of("scenarios/comets/models/karma.yaml"));
  lab.world.wind = {2.7, 4, 0};
  lab.flying_at({0, 0, 90});
  world::TerrainSpec spec = lab.world.terrain.spec();
  spec.hills.clear();
  Random random(seed, "hills");
  for (int i = 0; i < 25; ++i) {
    const double radius = random.uniform(60, 220);
    const world::Vector2 at(random.uniform(-350, 350), random.uniform(-350, 350));
    if (at.norm() > radius + 100)
      spec.hills.push_back({at, radius * random.uniform(0.3, 0.6), radius});
  }
  lab.world.terrain = world::Terrain(spec);
  return lab;
}

/// How deep in the ground some flight along the way is, with errors and gusts [m]; negative: how
/// far above it.
double depth_of(const refiners::Way& way, const PlanningLab& lab) {
  const world::VehicleModel& vehicle = lab.knowledge.vehicle;
  const refiners::Way rest(way.begin() + 1, way.end());
  double deepest = -1000;
  for (const Pose& pose : poses_at(way.front(), vehicle))
    for (std::uint64_t trial = 101; trial <= 104; ++trial)
      for (const Vector3& at : fly_way(pose, rest, vehicle, lab.world.wind, trial).track)
        deepest = std::max(deepest, lab.world.terrain.elevation(at.x(), at.y()) - at.z());
  return deepest;
}

TEST(SteepGround, WhatIsPlannedOverItIsNotFlownIntoIt) {
  std::size_t flights = 0, low = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    PlanningLab lab = among_hills(seed);
    const Vector3 corner(seed % 2 == 0 ? 300 : -300, seed % 3 == 0 ? 280 : -280, 0);
    const double ground = lab.world.terrain.elevation(corner.x(), corner.y());
    lab.task(1, "general-gotoxyz", {Vector3(corner.x(), corner.y(), ground + 70)});
    if (seed % 4 == 0) lab.task(2, "perform-detection", {"Z2"s, "P2"s, 60.0});
    const auto plan = lab.plan();
    if (!plan) continue;
    for (const mission::ElementaryTask& task : plan->tasks) {
      if (task.way.size() < 2) continue;
      ++flights;
      const double depth = depth_of(task.way, lab);
      EXPECT_LT(depth, 0) << "seed " << seed << ", " << task.type;
      low += depth > -25 ? 1 : 0;
    }
  }
  EXPECT_GE(flights, 12U);
  EXPECT_GE(low, 3U) << "the hills are not in its way";
}

/// Marvin beside a mountain that stands between it and its pad.
PlanningLab behind_a_mountain(double ceiling) {
  PlanningLab lab;
  lab.vehicle(vehicle_of("scenarios/comets/models/marvin.yaml"));
  lab.knowledge.vehicle.ceiling = ceiling;
  lab.world.wind = {};
  world::TerrainSpec spec = lab.world.terrain.spec();
  spec.hills = {{{0, 200}, 150, 120}};
  lab.world.terrain = world::Terrain(spec);
  return lab;
}

// Found by random missions (--clean --rough 1): it held with no contact, its way home was straight
// into the mountain, the vehicle refused that, and it hung there until its energy was used up.
TEST(SteepGround, AUavThatComesHomeOnItsOwnFliesAroundOrOverIt) {
  for (const double ceiling : {300.0, 10.0}) {  // with so low a one no way is planned
    const PlanningLab lab = behind_a_mountain(ceiling);
    const auto way =
        own_way(std::make_shared<const Knowledge>(lab.knowledge),
                std::make_shared<const world::World>(lab.world), {}, {0, 340, 40}, {0, 0, 40});
    ASSERT_GE(way.size(), 3U);
    EXPECT_EQ(way.front(), Vector3(0, 340, 40));
    EXPECT_EQ(way.back(), Vector3(0, 0, 40));
    for (std::size_t i = 1; i < way.size(); ++i)
      EXPECT_FALSE(lab.world.terrain.first_hit(way[i - 1], way[i], 2)) << "leg " << i;
  }
}

TEST(SteepGround, AFlightThatTurnsBesideItsWayMeetsIt) {
  world::TerrainSpec spec;
  spec.west = spec.south = -300;
  spec.east = spec.north = 300;
  spec.cell = 10;
  spec.hills = {{{-150, 0}, 250, 150}};
  const world::Terrain terrain(spec);
  world::VehicleModel plane;
  plane.hovers = false;
  plane.cruise_speed = 20;
  plane.min_turn_radius = 40;
  plane.orbit_radius = 60;
  const refiners::Way east{{0, 0, 30}, {200, 0, 30}};
  const auto meets = [&](double heading) {
    return flights_meet_ground(east, terrain, {5, 0, 100}, plane, {}, {{{0, 0, 30}, heading, 20}});
  };

  EXPECT_FALSE(meets(0));
  EXPECT_TRUE(meets(3.1));
}

}  // namespace
}  // namespace skein::supervisor::testing
