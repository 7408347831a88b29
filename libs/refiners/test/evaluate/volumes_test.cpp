// SPDX-License-Identifier: Apache-2.0
#include "evaluate/volumes.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

/// Like a U, open to the north, from 0 to 30 in both directions.
world::Volume u_shape() {
  world::Volume volume;
  volume.polygon = {{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};
  volume.floor = 10;
  volume.ceiling = 40;
  return volume;
}

TEST(EvaluateVolumes, ALegThroughBothArmsIsInsideTwice) {
  const auto parts = parts_inside(u_shape(), {-10, 20, 20}, {90, 20, 20});

  ASSERT_EQ(parts.size(), 2U);
  EXPECT_DOUBLE_EQ(parts[0].from, 0.1);
  EXPECT_DOUBLE_EQ(parts[0].until, 0.2);
  EXPECT_DOUBLE_EQ(parts[1].from, 0.3);
  EXPECT_DOUBLE_EQ(parts[1].until, 0.4);
}

TEST(EvaluateVolumes, ALegAlongTheCeilingIsOutside) {
  EXPECT_TRUE(parts_inside(u_shape(), {5, 5, 40}, {25, 5, 40}).empty());
  EXPECT_FALSE(parts_inside(u_shape(), {5, 5, 39.9}, {25, 5, 39.9}).empty());
}

TEST(EvaluateVolumes, AVerticalLegIsInsideBetweenFloorAndCeiling) {
  const auto parts = parts_inside(u_shape(), {5, 5, 0}, {5, 5, 100});

  ASSERT_EQ(parts.size(), 1U);
  EXPECT_DOUBLE_EQ(parts[0].from, 0.1);
  EXPECT_DOUBLE_EQ(parts[0].until, 0.4);
}

TEST(EvaluateVolumes, TouchingACornerIsOutside) {
  EXPECT_TRUE(parts_inside(u_shape(), {-10, 10, 20}, {10, -10, 20}).empty());
}

RC_GTEST_PROP(EvaluateVolumes, PartsAreWhereSamplesAreInside, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto place = [&] {
    return Vector3(random.uniform(-20, 50), random.uniform(-20, 50), random.uniform(0, 50));
  };
  const Vector3 from = place(), to = place();
  const world::Volume volume = u_shape();

  const auto parts = parts_inside(volume, from, to);

  for (int i = 0; i < 500; ++i) {
    const double f = (i + 0.5) / 500;
    const Vector3 at = from + f * (to - from);
    const bool inside = at.z() > volume.floor && at.z() < volume.ceiling &&
                        world::contains(volume.polygon, Vector2(at.x(), at.y()));
    bool told = false;
    for (const LegPart& part : parts) told = told || (f >= part.from && f <= part.until);
    RC_ASSERT(told == inside);
  }
}

LegTimes leg_of(double earliest, double latest, double least, double most) {
  return {MissionTime::seconds(earliest), MissionTime::seconds(latest), Duration::seconds(least),
          Duration::seconds(most)};
}
world::TimeWindow window_of(double from, double until) {
  return {MissionTime::seconds(from), MissionTime::seconds(until)};
}

TEST(EvaluateVolumes, AWindowThatIsOverBeforeTheFastestArrivalIsNoObstacle) {
  const LegTimes times = leg_of(100, 110, 10, 20);

  EXPECT_FALSE(first_within({0.5, 1}, times, window_of(0, 105)));
  EXPECT_TRUE(first_within({0.5, 1}, times, window_of(0, 106)));
}

TEST(EvaluateVolumes, AWindowThatOpensAfterTheSlowestHasLeftIsNoObstacle) {
  const LegTimes times = leg_of(100, 110, 10, 20);

  EXPECT_FALSE(first_within({0, 0.5}, times, window_of(121, 500)));
  EXPECT_TRUE(first_within({0, 0.5}, times, window_of(119, 500)));
}

TEST(EvaluateVolumes, TheFirstPlaceIsWhereTheWindowMayBeOpen) {
  const LegTimes times = leg_of(0, 0, 10, 20);

  const auto first = first_within({0.2, 0.9}, times, window_of(10, 100));

  ASSERT_TRUE(first);
  EXPECT_DOUBLE_EQ(*first, 0.5);
}

}  // namespace
}  // namespace skein::refiners
