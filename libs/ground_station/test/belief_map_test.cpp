// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/belief_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "skein/foundation/random.hpp"

namespace skein::ground_station {
namespace {

using world::Grid;
using world::Perception;
using world::Terrain;
using world::TerrainSpec;
using world::Vector3;

const Grid kGrid{-100, -100, 10, 20, 20};

// Level, with a hill in the east when it is asked for.
Terrain ground(double height_of_hill = 0) {
  TerrainSpec spec;
  spec.west = spec.south = -100;
  spec.east = spec.north = 100;
  spec.cell = 5;
  if (height_of_hill > 0) spec.hills.push_back({{40, 0}, height_of_hill, 15});
  return Terrain(spec);
}

// Straight down from 60 m: it sees 60 m × tan(0.5) = 33 m around.
Perception look_at(double x, double y, double at, const std::string& device = "fire-sensor") {
  Perception look;
  look.uav = "marvin";
  look.device = device;
  look.viewpoint = {x, y, 60};
  look.direction = -Vector3::UnitZ();
  look.range = 150;
  look.aperture = 0.5;
  look.at = MissionTime::seconds(at);
  return look;
}

std::size_t cell_at(double x, double y) { return *kGrid.at({x, y}); }

TEST(BeliefMap, KnowsNothingBeforeTheFirstLook) {
  const Terrain terrain = ground();
  const BeliefMap map({}, terrain, kGrid);

  for (std::size_t cell = 0; cell < kGrid.size(); ++cell) EXPECT_FALSE(map.belief(cell));
}

TEST(BeliefMap, ALookThatSeesNothingLowersBeliefWhereItLookedAndNowhereElse) {
  const Terrain terrain = ground();
  BeliefMap map({}, terrain, kGrid);

  const auto rows = map.handle(look_at(0, 0, 1));

  // By hand: 0.1 · 0.2 against 0.9 · 0.9.
  EXPECT_NEAR(map.belief(cell_at(5, 5)).value_or(0), 0.02 / (0.02 + 0.81), 1e-6);
  for (std::size_t cell = 0; cell < kGrid.size(); ++cell) {
    const double distance = kGrid.centre(cell).norm();
    if (distance > 31 && distance < 34) continue;  // on the border
    EXPECT_EQ(map.belief(cell).has_value(), distance < 32) << distance;
  }
  EXPECT_EQ(rows.front(), 7U) << "from 30 m in the south";
  EXPECT_EQ(rows.back(), 12U);
}

TEST(BeliefMap, BehindAHillNothingIsSaid) {
  const Terrain terrain = ground(80);
  BeliefMap map({}, terrain, kGrid);
  Perception look = look_at(0, 0, 1);
  look.viewpoint = {0, 0, 20};
  look.direction = Vector3::UnitX();
  look.aperture = 1.2;

  map.handle(look);

  EXPECT_TRUE(map.belief(cell_at(25, 5))) << "on this side";
  EXPECT_FALSE(map.belief(cell_at(75, 5))) << "on the other";
}

TEST(BeliefMap, ADetectionRaisesBeliefWithinItsGateAndLowersItInTheRestOfTheView) {
  const Terrain terrain = ground();
  BeliefMap map({}, terrain, kGrid);
  Perception look = look_at(0, 0, 1);
  look.aperture = 1;
  look.detections.push_back({"fire", {55, 5, 0}, 5, 0.9});

  map.handle(look);

  // By hand: 0.1 · 0.8 against 0.9 · 0.1; the gate is 25 m.
  EXPECT_NEAR(map.belief(cell_at(55, 5)).value_or(0), 0.08 / (0.08 + 0.09), 1e-6);
  EXPECT_GT(map.belief(cell_at(35, 5)).value_or(0), 0.1);
  EXPECT_LT(map.belief(cell_at(25, 5)).value_or(1), 0.1);
  EXPECT_FALSE(map.belief(cell_at(95, 95))) << "neither in view nor near what was detected";
}

TEST(BeliefMap, LooksCloserThanTheDecorrelationTimeCountOnceButForAHair) {
  const Terrain terrain = ground();
  BeliefMap map({}, terrain, kGrid);
  const auto belief_after = [&](double at) {
    map.handle(look_at(0, 0, at));
    return map.belief(cell_at(5, 5)).value_or(0);
  };

  const double first = belief_after(1.002);

  EXPECT_EQ(belief_after(1.8), first);
  EXPECT_LT(belief_after(2.0), first);
}

TEST(BeliefMap, OneDeviceNeverMakesCertain) {
  const Terrain terrain = ground();
  BeliefMap map({}, terrain, kGrid);

  for (int i = 0; i < 100; ++i) map.handle(look_at(0, 0, 2 * i));

  // The prior, and no more than the limit of a fire sensor, e^-5.
  EXPECT_NEAR(map.belief(cell_at(5, 5)).value_or(0),
              0.1 * std::exp(-5.0) / (0.1 * std::exp(-5.0) + 0.9), 1e-6);
}

TEST(BeliefMap, LooksOfOneDeviceThatAreTooCloseCountOnce) {
  const Terrain terrain = ground();
  BeliefMap map({}, terrain, kGrid);

  map.handle(look_at(0, 0, 1));
  const auto once = map.belief(cell_at(5, 5));
  EXPECT_TRUE(map.handle(look_at(0, 0, 1.5)).empty());

  EXPECT_EQ(map.belief(cell_at(5, 5)), once);
  map.handle(look_at(0, 0, 1.5, "ir"));
  EXPECT_LT(map.belief(cell_at(5, 5)), once) << "another device says something of its own";
}

TEST(BeliefMap, WhatMakesNoSenseChangesNothing) {
  const Terrain terrain = ground();
  BeliefMap map({}, terrain, kGrid);
  Perception nowhere = look_at(0, 0, 1), far = look_at(1e9, -1e9, 2), blind = look_at(0, 0, 3);
  nowhere.viewpoint.x() = std::numeric_limits<double>::quiet_NaN();
  blind.device = "thermometer";

  EXPECT_TRUE(map.handle(nowhere).empty());
  EXPECT_TRUE(map.handle(far).empty());
  EXPECT_TRUE(map.handle(blind).empty());
}

// The same as the ground station believes of a place when it has one candidate there.
TEST(BeliefMap, AgreesWithPerceptionProcessingOnOnePlace) {
  const Terrain terrain = ground();
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    PpsConfig config;
    config.infirm = 1e-9;
    BeliefMap map(config, terrain, kGrid);
    PerceptionProcessing pps(config, terrain);
    double at = 0;
    for (int i = 0; i < 30; ++i) {
      at += random.uniform(1, 5);
      const bool elsewhere = i >= 4 && random.chance(0.2);
      const bool infrared = i < 4 ? i % 2 == 0 : random.chance(0.5);
      Perception look = look_at(elsewhere ? 80 : random.uniform(-10, 20), random.uniform(-10, 20),
                                at, infrared ? "ir" : "fire-sensor");
      const bool sees = !elsewhere && (i < 4 || random.chance(0.5));
      if (sees) look.detections.push_back({"fire", {5, 5, 0}, 2, 0.9});
      map.handle(look);
      pps.handle(look, look.at);
    }
    ASSERT_EQ(pps.alarms().size(), 1U);
    EXPECT_NEAR(map.belief(cell_at(5, 5)).value_or(0), pps.alarms()[0].belief, 1e-4)
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace skein::ground_station
