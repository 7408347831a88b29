// SPDX-License-Identifier: Apache-2.0
// A motion that begins within moments of passing a place begins in flight.
#include "refinery/vehicle_start.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace skein::supervisor {
namespace {

using ::testing::SizeIs;
using world::Vector3;

world::VehicleModel plane() {
  world::VehicleModel model;
  model.hovers = false;
  model.cruise_speed = 20;
  model.min_turn_radius = 40;
  model.orbit_radius = 60;
  return model;
}

const Vector3 kPlace{100, 0, 50};

TEST(VehicleStart, NothingBeginsInFlightUnlessItFlies) {
  VehicleStart start(plane());
  EXPECT_FALSE(start.in_flight({0, 0}));
  start.stands_at(kPlace);
  EXPECT_EQ(start.stand(), kPlace);
  EXPECT_FALSE(start.in_flight({0, 0}));
}

TEST(VehicleStart, WhatDepartsWithinMomentsBeginsInFlight) {
  VehicleStart start(plane());
  start.flies_on(kPlace, 0);
  EXPECT_TRUE(start.in_flight({0, 10}));
  EXPECT_TRUE(start.in_flight({2, 10}));
  EXPECT_FALSE(start.in_flight({2.1, 10})) << "it circles first";
}

TEST(VehicleStart, InFlightItGoesOnAsItWasOrHasBegunToCircle) {
  VehicleStart start(plane());
  start.flies_on(kPlace, std::numbers::pi / 2);
  const auto poses = start.poses(kPlace, true);
  ASSERT_THAT(poses, SizeIs(5));
  for (int second = 0; second < 3; ++second) {
    EXPECT_NEAR((poses[second].at - (kPlace + Vector3(0, 20.0 * second, 0))).norm(), 0, 1e-9);
    EXPECT_DOUBLE_EQ(poses[second].heading, std::numbers::pi / 2);
  }
  const double turned = 2 * 20.0 / 40;
  EXPECT_DOUBLE_EQ(poses[3].heading, std::numbers::pi / 2 - turned);
  EXPECT_DOUBLE_EQ(poses[4].heading, std::numbers::pi / 2 + turned);
  for (const Pose& pose : poses) EXPECT_EQ(pose.speed, 20);
}

TEST(VehicleStart, ElsewhereOrLaterItBeginsFromAnyHeading) {
  VehicleStart start(plane());
  start.flies_on(kPlace, 0);
  const auto any = poses_at(kPlace, plane());
  EXPECT_EQ(start.poses(kPlace, false).size(), any.size());
  EXPECT_EQ(start.poses(kPlace + Vector3(1, 0, 0), true).size(), any.size());
  EXPECT_NE(start.poses(kPlace, true).size(), any.size());
}

TEST(VehicleStart, WhatItPassesNowCountsAndNotWhatItPassedBefore) {
  VehicleStart start(plane());
  start.flies_on(kPlace, 0);
  start.flies_on(Vector3::Zero(), 1);
  EXPECT_THAT(start.poses(Vector3::Zero(), true), SizeIs(5));
  EXPECT_EQ(start.poses(kPlace, true).size(), poses_at(kPlace, plane()).size());
}

}  // namespace
}  // namespace skein::supervisor
