// SPDX-License-Identifier: Apache-2.0
#include "skein/world/way_energy.hpp"

#include <gtest/gtest.h>

namespace skein::world {
namespace {

/// Hovers with 1000 W, cruises at 10 m/s with 800 W, climbs 2 m/s with 300 W on top.
VehicleModel a_model() {
  VehicleModel model;
  model.cruise_speed = 10;
  model.climb_rate = 2;
  model.descent_rate = 4;
  model.energy = {1e6, 50, 1000, 800, 300, 0.1};
  return model;
}

TEST(WayEnergy, OfALevelWayIsItsTimeAtThePowerOfItsSpeed) {
  EXPECT_DOUBLE_EQ(energy_asked_for(a_model(), {0, 0, 40}, {{100, 0, 40}, {100, 200, 40}}, 10),
                   30 * 800);
}

TEST(WayEnergy, ClimbingTakesMoreAndLastsWhatItsRateSays) {
  EXPECT_DOUBLE_EQ(energy_asked_for(a_model(), {0, 0, 40}, {{0, 0, 60}}, 10), 10 * (1000 + 300));
  EXPECT_DOUBLE_EQ(energy_asked_for(a_model(), {0, 0, 40}, {{100, 0, 50}}, 10), 10 * 800 + 5 * 300);
}

TEST(WayEnergy, SinkingTakesWhatItsTimeTakes) {
  EXPECT_DOUBLE_EQ(energy_asked_for(a_model(), {0, 0, 40}, {{0, 0, 0}}, 10), 10 * 1000);
}

TEST(WayEnergy, OneThatCannotHoverAsksForItsTurnsToo) {
  VehicleModel model = a_model();
  model.hovers = false;

  EXPECT_DOUBLE_EQ(energy_asked_for(model, {0, 0, 40}, {{100, 0, 40}}, 10), 1.2 * 10 * 800);
}

}  // namespace
}  // namespace skein::world
