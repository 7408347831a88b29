// SPDX-License-Identifier: Apache-2.0
// A part of a shared area in which air is closed, now or later (decision 132).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/world/segment.hpp"
#include "testing/shared_field.hpp"

namespace skein::decision_node {
namespace {

using testing::agreed;
using testing::kEast;
using testing::kWest;
using testing::setting_at;

/// The same, where the air over the west is closed from then on, for ten minutes.
SweepSetting setting_until_closed(double seconds) {
  SweepSetting setting = setting_at({-50, -20, 60});
  auto world = std::make_shared<world::World>(*setting.world);
  world->volumes.push_back(
      {"V", kWest, 0, 200, {MissionTime::seconds(seconds), MissionTime::seconds(seconds + 600)}});
  setting.world = world;
  return setting;
}

// Found by random missions (--sharing 338): its part of two minutes was refused for air that closes
// ten minutes later.
TEST(ClosedPart, AirThatClosesAfterItsPartIsFlownDoesNotCount) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));

  EXPECT_TRUE(share.set_out(setting_until_closed(600)));
}

// Found by random missions (--sharing 67): half a minute of closed air over a corner was the end of
// a mapping of six minutes.
TEST(ClosedPart, AirThatClosesLaterThanItSetsOutIsWatchedInFlight) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));

  EXPECT_TRUE(share.set_out(setting_until_closed(90)));
}

TEST(ClosedPart, WhereAirIsClosedForATimeItIsSaidWhenItOpens) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));

  const auto way = share.set_out(setting_until_closed(0));

  ASSERT_FALSE(way);
  EXPECT_THAT(way.error().why, ::testing::HasSubstr("V"));
  EXPECT_EQ(way.error().opens, MissionTime::seconds(600));
  EXPECT_NEAR(share.area_left(), 40000, 1e-6);
}

// Found by hand (area-sharing/air-closes): smoke over a part of a field was the end of the mapping.
TEST(ClosedPart, WhatLiesBesideClosedAirIsFlownAndTheRestIsLeft) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  SweepSetting setting = setting_until_closed(0), open = setting_at({-50, -20, 60});
  auto world = std::make_shared<world::World>(*setting.world);
  world->volumes.back().polygon = {{50, 50}, {150, 50}, {150, 150}, {50, 150}};
  setting.world = world;

  const auto way = share.set_out(setting);
  ASSERT_TRUE(way) << way.error().why;
  for (const world::Vector3& at : *way)
    EXPECT_GT(world::to_polygon(at.head<2>(), world->volumes.back().polygon), 0);
  share.flown();

  EXPECT_GT(share.area_left(), 100 * 100);
  EXPECT_LT(share.area_left(), 170 * 170);
  const auto rest = share.set_out(setting);
  ASSERT_FALSE(rest) << rest->size() << " " << share.area_left();
  EXPECT_EQ(rest.error().opens, MissionTime::seconds(600));
  EXPECT_TRUE(share.set_out(open));
  share.flown();
  EXPECT_EQ(share.area_left(), 0);
}

TEST(ClosedPart, WhereAirStaysClosedOrThereIsNoDeviceNothingIsWaitedFor) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  SweepSetting for_ever = setting_until_closed(0), blind = for_ever;
  auto world = std::make_shared<world::World>(*for_ever.world);
  world->volumes.back().when.until = MissionTime::max();
  for_ever.world = world;
  blind.device = "none";

  for (const SweepSetting& setting : {for_ever, blind}) {
    const auto way = share.set_out(setting);
    ASSERT_FALSE(way);
    EXPECT_EQ(way.error().opens, std::nullopt);
  }
}

}  // namespace
}  // namespace skein::decision_node
