// SPDX-License-Identifier: Apache-2.0
#include "skein/world/sensor_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace skein::world {
namespace {

const View kEast = {{10, 0, 0}, Vector3::UnitX(), 100, 0.5};

TEST(InView, IsTheConeWithinRange) {
  struct Case {
    Vector3 point;
    bool seen;
  };
  const double edge = 50 * std::tan(0.5);
  const Case cases[] = {
      {{60, 0, 0}, true},           {{60, edge - 0.01, 0}, true},  {{60, edge + 0.01, 0}, false},
      {{60, 0, edge - 0.01}, true}, {{60, 0, edge + 0.01}, false}, {{0, 0, 0}, false},
      {{109.9, 0, 0}, true},        {{110.1, 0, 0}, false},        {{10, 0, 0}, true},
  };
  for (const Case& c : cases) EXPECT_EQ(in_view(kEast, c.point), c.seen) << c.point.transpose();
}

TEST(InView, ABallIsSeenWhenItsEdgeIs) {
  const Vector3 aside = Vector3(10, 0, 0) + 50 * Vector3(std::cos(0.6), std::sin(0.6), 0);
  const double needed = 50 * std::sin(0.1);

  EXPECT_FALSE(in_view(kEast, aside, needed - 0.01));
  EXPECT_TRUE(in_view(kEast, aside, needed + 0.01));
  EXPECT_TRUE(in_view(kEast, {112, 0, 0}, 3)) << "its near side is in range";
}

TEST(InView, FromWithinABallEverythingIsSeen) {
  EXPECT_TRUE(in_view(kEast, {5, 0, 0}, 6)) << "though its centre is behind";
}

/// Fades from 50 m to a quarter at 250 m.
SensorModel a_camera() {
  SensorModel camera;
  camera.range = 250;
  camera.quality = {50, 0.25, 1};
  return camera;
}

TEST(PerceivedQuality, IsOneWithoutAModelOfIt) {
  SensorModel plain;
  plain.range = 100;

  EXPECT_EQ(perceived_quality(plain, {100, 0, 0}, {0, 0, 0}, Vector3::UnitZ()), 1);
  EXPECT_EQ(perceived_quality(plain, {0, 0, -5}, {0, 0, 0}, Vector3::UnitZ()), 1);
  EXPECT_EQ(perceived_quality(plain, {100.1, 0, 0}, {0, 0, 0}, Vector3::UnitZ()), 0);
}

TEST(PerceivedQuality, FallsLinearlyWithDistanceFromTheBestToTheRange) {
  const SensorModel camera = a_camera();
  const auto from_above = [&](double height) {
    return perceived_quality(camera, {0, 0, height}, {0, 0, 0}, Vector3::UnitZ());
  };

  EXPECT_DOUBLE_EQ(from_above(10), 1);
  EXPECT_DOUBLE_EQ(from_above(50), 1);
  EXPECT_DOUBLE_EQ(from_above(150), 0.625);
  EXPECT_DOUBLE_EQ(from_above(250), 0.25);
  EXPECT_EQ(from_above(250.001), 0);
}

TEST(PerceivedQuality, FallsWithThePowerOfTheCosineOfIncidence) {
  SensorModel camera = a_camera();
  const Vector3 aside = 40 * Vector3(std::sin(1.0), 0, std::cos(1.0));

  EXPECT_DOUBLE_EQ(perceived_quality(camera, aside, {0, 0, 0}, Vector3::UnitZ()), std::cos(1.0));
  camera.quality.incidence_power = 2;
  EXPECT_DOUBLE_EQ(perceived_quality(camera, aside, {0, 0, 0}, Vector3::UnitZ()),
                   std::cos(1.0) * std::cos(1.0));
  EXPECT_NEAR(perceived_quality(camera, aside, {0, 0, 0}, aside.normalized()), 1, 1e-12)
      << "a slope that faces the sensor";
  EXPECT_EQ(perceived_quality(camera, aside, {0, 0, 0}, -aside.normalized()), 0)
      << "one that faces away";
}

TEST(PerceivedQuality, AtTheTargetItselfIncidenceDoesNotMatter) {
  EXPECT_EQ(perceived_quality(a_camera(), {1, 2, 3}, {1, 2, 3}, Vector3::UnitX()), 1);
}

TEST(PerceivedQuality, ABestDistanceOfTheWholeRangeLeavesNothingToFade) {
  SensorModel camera = a_camera();
  camera.quality.best_distance = camera.range;

  EXPECT_EQ(distance_quality(camera, 250), 1);
  EXPECT_EQ(distance_quality(camera, 251), 0);
}

RC_GTEST_PROP(PerceivedQuality, IsAFractionAndNeverBetterFurtherAway, ()) {
  const auto within = [](int low, int high) { return *rc::gen::inRange(low, high) * 0.01; };
  SensorModel camera;
  camera.range = within(1, 30000);
  camera.quality = {camera.range * within(0, 101), within(0, 101), within(0, 400)};
  const Vector3 direction = direction_of(within(-314, 315), within(-157, 158)), normal(0, 0, 1);
  const double near = within(0, 40000), far = near + within(0, 10000);

  const double nearer = perceived_quality(camera, near * direction, Vector3::Zero(), normal);
  const double farther = perceived_quality(camera, far * direction, Vector3::Zero(), normal);

  RC_ASSERT(nearer >= 0 && nearer <= 1);
  RC_ASSERT(near == 0 || farther <= nearer + 1e-12);
}

}  // namespace
}  // namespace skein::world
