// SPDX-License-Identifier: Apache-2.0
// Looks that come after younger ones.
#include <gtest/gtest.h>

#include "skein/ground_station/perception_processing.hpp"
#include "testing/builders.hpp"
#include "testing/looks.hpp"

namespace skein::ground_station {
namespace {

using testing::flat_terrain;
using testing::look;
using testing::seeing;

/// Marvin's fire sensor sees fire below.
world::Perception sight(double at) { return seeing(look("marvin", "fire-sensor", at), "fire"); }

// What came by an event that had to be said again.
TEST(LateLooks, ALookThatComesAfterYoungerOnesCountsAsIfItHadComeInTime) {
  PerceptionProcessing in_time({}, flat_terrain()), late({}, flat_terrain());
  for (const double at : {1.0, 2.0, 3.0}) in_time.handle(sight(at), MissionTime::seconds(at));
  for (const double at : {1.0, 3.0, 2.0}) late.handle(sight(at), MissionTime::seconds(3));

  ASSERT_EQ(in_time.alarms().size(), 1U);
  ASSERT_EQ(late.alarms().size(), 1U);
  EXPECT_DOUBLE_EQ(late.alarms()[0].belief, in_time.alarms()[0].belief);
  EXPECT_EQ(late.alarms()[0].last_seen, in_time.alarms()[0].last_seen);
}

TEST(LateLooks, ALateLookCountsOnceAndNotBesideOneThatIsTooClose) {
  PerceptionProcessing pps({}, flat_terrain());
  for (const double at : {1.0, 2.0, 3.0, 5.0}) pps.handle(sight(at), MissionTime::seconds(at));
  const auto views = pps.alarms().at(0).views;

  for (const double at : {3.0, 2.5, 4.5}) pps.handle(sight(at), MissionTime::seconds(5));
  EXPECT_EQ(pps.alarms().at(0).views, views);
  pps.handle(sight(4), MissionTime::seconds(5));
  EXPECT_EQ(pps.alarms().at(0).views, views + 1);
}

TEST(LateLooks, ALookOfMinutesAgoIsNotCounted) {
  PerceptionProcessing pps({}, flat_terrain());
  for (const double at : {200.0, 201.0, 202.0}) pps.handle(sight(at), MissionTime::seconds(at));
  const auto views = pps.alarms().at(0).views;

  pps.handle(sight(81), MissionTime::seconds(202));
  EXPECT_EQ(pps.alarms().at(0).views, views);
}

}  // namespace
}  // namespace skein::ground_station
