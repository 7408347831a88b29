// SPDX-License-Identifier: Apache-2.0
// Looks that come after younger ones.
#include <gtest/gtest.h>

#include "skein/ground_station/perception_processing.hpp"

namespace skein::ground_station {
namespace {

const world::Terrain& level_ground() {
  static const world::Terrain terrain(world::TerrainSpec{.west = -1000,
                                                         .south = -1000,
                                                         .east = 1000,
                                                         .north = 1000,
                                                         .cell = 100,
                                                         .base = 0,
                                                         .hills = {},
                                                         .elevations = {}});
  return terrain;
}

/// Marvin's fire sensor sees fire straight below.
world::Perception sight(double at) {
  world::Perception look;
  look.uav = "marvin";
  look.device = "fire-sensor";
  look.viewpoint = {5, 0, 60};
  look.direction = {0, 0, -1};
  look.range = 150;
  look.aperture = 0.8;
  look.at = MissionTime::seconds(at);
  look.detections.push_back({"fire", {0, 0, 0}, 5, 0.9});
  return look;
}

// What came by an event that had to be said again.
TEST(LateLooks, ALookThatComesAfterYoungerOnesCountsAsIfItHadComeInTime) {
  PerceptionProcessing in_time({}, level_ground()), late({}, level_ground());
  for (const double at : {1.0, 2.0, 3.0}) in_time.handle(sight(at), MissionTime::seconds(at));
  for (const double at : {1.0, 3.0, 2.0}) late.handle(sight(at), MissionTime::seconds(3));

  ASSERT_EQ(in_time.alarms().size(), 1U);
  ASSERT_EQ(late.alarms().size(), 1U);
  EXPECT_DOUBLE_EQ(late.alarms()[0].belief, in_time.alarms()[0].belief);
  EXPECT_EQ(late.alarms()[0].last_seen, in_time.alarms()[0].last_seen);
}

TEST(LateLooks, ALateLookCountsOnceAndNotBesideOneThatIsTooClose) {
  PerceptionProcessing pps({}, level_ground());
  for (const double at : {1.0, 2.0, 3.0, 5.0}) pps.handle(sight(at), MissionTime::seconds(at));
  const auto views = pps.alarms().at(0).views;

  for (const double at : {3.0, 2.5, 4.5}) pps.handle(sight(at), MissionTime::seconds(5));
  EXPECT_EQ(pps.alarms().at(0).views, views);
  pps.handle(sight(4), MissionTime::seconds(5));
  EXPECT_EQ(pps.alarms().at(0).views, views + 1);
}

TEST(LateLooks, ALookOfMinutesAgoIsNotCounted) {
  PerceptionProcessing pps({}, level_ground());
  for (const double at : {200.0, 201.0, 202.0}) pps.handle(sight(at), MissionTime::seconds(at));
  const auto views = pps.alarms().at(0).views;

  pps.handle(sight(81), MissionTime::seconds(202));
  EXPECT_EQ(pps.alarms().at(0).views, views);
}

}  // namespace
}  // namespace skein::ground_station
