// SPDX-License-Identifier: Apache-2.0
// What a vehicle's model says of its own devices.
#include <gtest/gtest.h>

#include "skein/ground_station/perception_processing.hpp"

namespace skein::ground_station {
namespace {

/// Twenty looks straight down at a place where the device reports a fire each time.
void report_fire(PerceptionProcessing& pps, const std::string& device, double from) {
  for (int i = 0; i < 20; ++i) {
    world::Perception look;
    look.uav = "marvin";
    look.device = device;
    look.viewpoint = {105, 50, 60};
    look.direction = -world::Vector3::UnitZ();
    look.range = 150;
    look.aperture = 0.8;
    look.at = MissionTime::seconds(from + 2.0 * i);
    look.detections.push_back({"fire", {100, 50, 0}, 5, 0.9});
    pps.handle(look, look.at);
  }
}

TEST(DeviceModels, CountBeforeTheNameOfADevice) {
  world::TerrainSpec level;
  level.west = level.south = -1000;
  level.east = level.north = 1000;
  const world::Terrain terrain(level);
  PpsConfig config;
  config.models[{"marvin", "fire-sensor"}] = {.kinds = {{"fire", {0.2, 0.2}}}};
  config.models[{"marvin", "nose"}] = {.kinds = {{"fire", {0.9, 0.01}}}, .limit = 9};
  PerceptionProcessing pps(config, terrain);

  report_fire(pps, "fire-sensor", 0);
  EXPECT_TRUE(pps.alarms().empty()) << "as often where nothing burns as where something does";
  report_fire(pps, "nose", 100);
  EXPECT_EQ(pps.alarms().size(), 1U);
}

}  // namespace
}  // namespace skein::ground_station
