// SPDX-License-Identifier: Apache-2.0
#include "skein/world/steering.hpp"

#include <gtest/gtest.h>

namespace skein::world {
namespace {

VehicleModel drifting() {
  VehicleModel model;
  model.hovers = true;
  model.position_precision = 0.5;
  model.acceleration = 2;
  model.wind_drift = 0.1;
  return model;
}

TEST(ReachingDistance, GrowsWithTheWindForWhatHovers) {
  Wind wind;
  EXPECT_DOUBLE_EQ(reaching_distance(drifting(), wind), 2.5);
  wind.speed = 4;
  wind.gusts = 2;
  EXPECT_DOUBLE_EQ(reaching_distance(drifting(), wind), 2.5 + 2);
}

TEST(ReachingDistance, KnowsNoWindForWhatCirclesItsPlaces) {
  VehicleModel circling = drifting();
  circling.hovers = false;
  EXPECT_DOUBLE_EQ(reaching_distance(circling, {0, 9, 3}), 2.5);
}

TEST(BrakingDistance, IsFlownInTheTimeThatTheSpeedTakesToGo) {
  const VehicleModel model = drifting();
  const double speed = 6, time = speed / model.acceleration;
  EXPECT_DOUBLE_EQ(braking_distance(model, speed), speed * time / 2);
  EXPECT_DOUBLE_EQ(braking_distance(model, 0), 0);
}

}  // namespace
}  // namespace skein::world
