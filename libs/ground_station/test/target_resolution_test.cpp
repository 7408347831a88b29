// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/target_resolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using testing::flat_terrain;
using world::Terrain;
using world::TerrainSpec;
using world::Vector3;

Alarm alarm_at(double x, double y) {
  Alarm alarm;
  alarm.id = AlarmId(1);
  alarm.position = {x, y, 0};
  return alarm;
}

const Terrain& hill() {
  static const Terrain terrain(TerrainSpec{.west = -500,
                                           .south = -500,
                                           .east = 500,
                                           .north = 500,
                                           .cell = 10,
                                           .base = 5,
                                           .hills = {{{100, 0}, 80, 60}},
                                           .elevations = {}});
  return terrain;
}

TEST(Resolve, FixedPointsStayAsTheyAre) {
  const auto points = resolve({AtPoints{{{1, 2, 3}, {4, 5, 6}}}, "to"}, nullptr, flat_terrain());

  ASSERT_TRUE(points.has_value());
  EXPECT_EQ(*points, (std::vector<Vector3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Resolve, NearTheAlarmIsSeenFromTheAlarmAndAboveTheGroundThere) {
  const Alarm alarm = alarm_at(100, 100);
  const NearAlarm south{-std::numbers::pi / 2, 100, 30};

  const auto points = resolve({south, "to"}, &alarm, hill());

  ASSERT_TRUE(points.has_value());
  ASSERT_EQ(points->size(), 1U);
  EXPECT_NEAR(points->front().x(), 100, 1e-9);
  EXPECT_NEAR(points->front().y(), 0, 1e-9);
  EXPECT_NEAR(points->front().z(), 5 + 80 + 30, 1) << "on the top of the hill";
}

TEST(Resolve, TheAlarmItselfIsItsPosition) {
  const Alarm alarm = alarm_at(10, 20);

  const auto points = resolve({TheAlarm{}, "target"}, &alarm, flat_terrain());

  ASSERT_TRUE(points.has_value());
  EXPECT_EQ(points->front(), alarm.position);
}

TEST(Resolve, APatternsLegsClearTheHighestGroundUnderThem) {
  const OverZone over{{{-200, -20}, {200, -20}, {200, 20}, {-200, 20}}, 100, 40, false};

  const auto points = resolve({over, "to"}, nullptr, hill());

  ASSERT_TRUE(points.has_value());
  ASSERT_EQ(points->size(), 2U);
  EXPECT_NEAR((*points)[0].z(), 5 + 80 + 40, 1);
  EXPECT_EQ((*points)[0].z(), (*points)[1].z());
}

TEST(Resolve, TheWholeWayOfAPatternClearsTheGround) {
  const Alarm alarm = alarm_at(100, 60);
  const OverZone over{{{60, -150}, {140, -150}, {140, 150}, {60, 150}}, 15, 20, true};

  const auto points = resolve({over, "to"}, &alarm, hill());

  ASSERT_TRUE(points.has_value());
  for (std::size_t i = 0; i + 1 < points->size(); ++i) {
    // The ground is looked at every 10 m; the hill is no steeper than 65 degrees.
    EXPECT_TRUE(hill().line_of_sight((*points)[i], (*points)[i + 1], 9)) << "stretch " << i;
  }
}

TEST(Resolve, APatternAroundTheAlarmBeginsNearIt) {
  const Alarm alarm = alarm_at(190, 90);
  const OverZone over{{{0, 0}, {200, 0}, {200, 100}, {0, 100}}, 20, 40, true};

  const auto points = resolve({over, "to"}, &alarm, flat_terrain());

  ASSERT_TRUE(points.has_value());
  EXPECT_NEAR(points->front().x(), 200, 1e-9);
  EXPECT_NEAR(points->front().y(), 90, 1e-9);
  EXPECT_EQ(points->size(), 10U);
}

TEST(Resolve, FailsWithTheReason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Alarm alarm = alarm_at(0, 0);
  struct Case {
    Target target;
    const Alarm* subject;
    std::string why;
  };
  const std::vector<Case> table = {
      {{AtPoints{}, "to"}, nullptr, "no points"},
      {{AtPoints{{{nan, 0, 0}}}, "to"}, nullptr, "a figure is not finite"},
      {{NearAlarm{}, "to"}, nullptr, "there is no alarm to be near to"},
      {{NearAlarm{nan, 10, 10}, "to"}, &alarm, "a figure is not finite"},
      {{TheAlarm{}, "to"}, nullptr, "there is no alarm"},
      {{OverZone{{{0, 0}, {9, 0}, {0, 9}}, 5, 5, true}, "to"},
       nullptr,
       "there is no alarm to begin at"},
      {{OverZone{{}, 5, 5, false}, "to"},
       nullptr,
       "the zone has no area, or the spacing does not suit it"},
  };

  for (const Case& c : table) {
    const auto points = resolve(c.target, c.subject, flat_terrain());

    ASSERT_FALSE(points.has_value()) << c.why;
    EXPECT_EQ(points.error().why, c.why);
  }
}

}  // namespace
}  // namespace skein::ground_station
