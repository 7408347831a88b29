// SPDX-License-Identifier: Apache-2.0
// By how much ways around closed air are longer than straight flights through it.
#include "skein/supervisor/detours.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using world::Vector3;

world::Volume closed_box(double west, double south, double east, double north, MissionTime until) {
  return {"box",
          {{west, south}, {east, south}, {east, north}, {west, north}},
          0,
          500,
          {MissionTime(), until}};
}

/// Without wind, so that ways may be compared by their lengths.
DetourRequest among(std::vector<world::Volume> volumes, std::vector<StraightLeg> legs) {
  testing::PlanningLab lab;
  lab.world.volumes = std::move(volumes);
  lab.world.wind = {};
  DetourRequest request;
  request.knowledge = std::make_shared<const Knowledge>(lab.knowledge);
  request.world = std::make_shared<const world::World>(lab.world);
  request.legs = std::move(legs);
  return request;
}

const StraightLeg kAcross{{0, 200, 60}, {200, 200, 60}};

TEST(Detours, AWallIsFlownAround) {
  const auto request = among({closed_box(90, 100, 110, 300, MissionTime::max())}, {kAcross});
  ASSERT_TRUE(goes_through(*request.knowledge, *request.world, request.now, kAcross));

  const auto detours = plan_detours(request);

  ASSERT_EQ(detours.size(), 1U);
  EXPECT_TRUE(detours[0].exists);
  // Past a corner of the wall, which is 100 m off the straight line, and not by twice as much.
  const double speed = request.knowledge->vehicle.cruise_speed;
  const double least = (2 * std::hypot(100, 90) - 200) / speed;
  EXPECT_GE(detours[0].longer.to_seconds(), least);
  EXPECT_LE(detours[0].longer.to_seconds(), 2 * least + 60 / speed);
  EXPECT_GT(detours[0].energy, 0);
}

TEST(Detours, ThereIsNoWayToWhatIsClosedForEver) {
  const auto all_around = closed_box(100, 100, 300, 300, MissionTime::max());
  EXPECT_FALSE(plan_detours(among({all_around}, {kAcross})).at(0).exists);
}

TEST(Detours, ThereIsOneToWhatWillOpen) {
  const auto for_a_while = closed_box(100, 100, 300, 300, MissionTime::seconds(500));
  EXPECT_TRUE(plan_detours(among({for_a_while}, {kAcross})).at(0).exists);
}

TEST(Detours, WhoIsInClosedAirItselfKnowsNothing) {
  const auto around_it = closed_box(-100, 100, 50, 300, MissionTime::max());
  EXPECT_EQ(plan_detours(among({around_it}, {kAcross})).at(0), Detour());
}

TEST(Detours, WithoutTimeTheFirstLegIsOverAndTheOthersAreLeft) {
  const auto request =
      among({closed_box(90, 100, 110, 300, MissionTime::max())}, {kAcross, kAcross, kAcross});

  const auto detours = plan_detours(request, [] { return true; });

  ASSERT_EQ(detours.size(), 1U);
  EXPECT_EQ(detours[0], Detour());
}

/// What is said to be free is flown straight: whoever does not ask for its detour misses nothing.
RC_GTEST_PROP(DetoursLaw, WhatIsFreeHasNone, ()) {
  const auto anywhere = [](double height) {
    return Vector3(*rc::gen::inRange(0, 400), *rc::gen::inRange(0, 400), height);
  };
  std::vector<world::Volume> volumes;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    const double west = *rc::gen::inRange(0, 350), south = *rc::gen::inRange(0, 350);
    volumes.push_back(closed_box(west, south, west + *rc::gen::inRange(10, 80),
                                 south + *rc::gen::inRange(10, 80), MissionTime::max()));
  }
  const StraightLeg leg{anywhere(90), anywhere(90)};
  const auto request = among(std::move(volumes), {leg});
  if (goes_through(*request.knowledge, *request.world, request.now, leg)) return;

  const Detour detour = plan_detours(request).at(0);

  RC_ASSERT(detour.exists);
  // Voxels of closed air are somewhat larger than it.
  RC_ASSERT(detour.longer.to_seconds() * request.knowledge->vehicle.cruise_speed < 120);
}

}  // namespace
}  // namespace skein::supervisor
