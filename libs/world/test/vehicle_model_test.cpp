// SPDX-License-Identifier: Apache-2.0
#include "skein/world/vehicle_model.hpp"

#include <gtest/gtest.h>

namespace skein::world {
namespace {

VehicleModel a_model() {
  VehicleModel model;
  model.cruise_speed = 10;
  model.climb_rate = 2;
  model.energy = {1e6, 50, 1000, 800, 300, 0.1};
  model.position_precision = 3;
  model.sensors.resize(2);
  model.sensors[0].device = "visible";
  model.sensors[1].device = "ir";
  return model;
}

TEST(VehicleModel, PowerIsAsGivenAtRestAtCruiseAndInAClimb) {
  EXPECT_EQ(flight_power(a_model(), 0, 0), 1000);
  EXPECT_EQ(flight_power(a_model(), 10, 0), 800);
  EXPECT_EQ(flight_power(a_model(), 0, 2), 1300);
  EXPECT_EQ(flight_power(a_model(), 0, 1), 1150);
}

TEST(VehicleModel, SinkingGivesNothingBack) { EXPECT_EQ(flight_power(a_model(), 0, -2), 1000); }

TEST(VehicleModel, PowerNeverFallsBelowThatOnTheGround) {
  EXPECT_EQ(flight_power(a_model(), 1000, 0), 50);
}

TEST(VehicleModel, APilotAddsToTheTrackingSpread) {
  VehicleModel model = a_model();
  EXPECT_EQ(tracking_spread(model), 3);

  model.pilot = PilotModel{};
  model.pilot->position_imprecision = 4;
  EXPECT_EQ(tracking_spread(model), 5);
}

TEST(VehicleModel, SensorsAreFoundByDevice) {
  const VehicleModel model = a_model();
  EXPECT_EQ(find_sensor(model, "ir"), &model.sensors[1]);
  EXPECT_EQ(find_sensor(model, "sonar"), nullptr);
}

TEST(VehicleModel, KindsHaveTheNamesOfTheFiles) {
  EXPECT_EQ(to_text(VehicleKind::kHelicopter), "helicopter");
  EXPECT_EQ(to_text(VehicleKind::kBlimp), "blimp");
  EXPECT_EQ(to_text(VehicleKind::kFixedWing), "fixed-wing");
}

}  // namespace
}  // namespace skein::world
