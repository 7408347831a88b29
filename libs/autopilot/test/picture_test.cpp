// SPDX-License-Identifier: Apache-2.0
#include "picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "mav.hpp"
#include "testing/rig.hpp"

namespace skein::autopilot {
namespace {

constexpr double kGeoid = 47;
Duration at(double seconds) { return Duration::seconds(seconds); }

class PictureTest : public ::testing::Test {
 protected:
  void beat(bool armed, double seconds = 0) {
    mavlink::Heartbeat heartbeat;
    heartbeat.autopilot = mav::kArdupilot;
    heartbeat.base_mode = armed ? mav::kArmedFlag : 0;
    picture_.hear(heartbeat, at(seconds));
  }
  /// As an autopilot that stands or flies there says it, armed at the origin.
  mavlink::GlobalPositionInt position(const world::Vector3& local) const {
    const auto point = geodesy::GeodeticFrame(config_.origin).to_geodetic(local);
    mavlink::GlobalPositionInt position;
    position.lat = static_cast<std::int32_t>(point.latitude_degrees * 1e7);
    position.lon = static_cast<std::int32_t>(point.longitude_degrees * 1e7);
    position.alt = static_cast<std::int32_t>((point.altitude - kGeoid) * 1e3);
    position.relative_alt = static_cast<std::int32_t>((local.z() - 120) * 1e3);
    return position;
  }

  BridgeConfig config_ = testing::Rig::config();
  Picture picture_{config_};
};

TEST_F(PictureTest, OnTheGroundItStandsOnTheTerrainWhateverTheGeoid) {
  beat(false);
  picture_.hear(position({50, -30, 120}), at(0));

  EXPECT_NEAR((picture_.state().position - world::Vector3(50, -30, 120)).norm(), 0, 0.05);
  EXPECT_FALSE(picture_.state().airborne);
}

TEST_F(PictureTest, HeightsInTheAirAreCountedFromThere) {
  beat(false);
  picture_.hear(position({0, 0, 120}), at(0));
  beat(true, 1);
  picture_.hear(position({200, 100, 165}), at(1));

  EXPECT_NEAR((picture_.state().position - world::Vector3(200, 100, 165)).norm(), 0, 0.05);
  EXPECT_TRUE(picture_.state().airborne);
}

TEST_F(PictureTest, HeardFirstInTheAirItIsAsHighOverItsStartAsOverItsHome) {
  beat(true);
  picture_.hear(position({200, 100, 165}), at(0));

  EXPECT_NEAR(picture_.state().position.z(), 165, 0.05);
}

TEST_F(PictureTest, NothingIsUnderTheGround) {
  for (double east = -300; east < 300; east += 7) {
    beat(false);
    picture_.hear(position({east, 480, 150}), at(0));
    const auto& place = picture_.state().position;
    EXPECT_GE(place.z(), config_.terrain.elevation(place.x(), place.y()));
  }
}

TEST_F(PictureTest, PlacesOfCommandsAreThoseThatAreTold) {
  beat(false);
  picture_.hear(position({0, 0, 120}), at(0));
  const auto there = position({300, -200, 180});

  const Place place = picture_.place_of({300, -200, 180});

  EXPECT_NEAR(place.latitude, there.lat, 2);
  EXPECT_NEAR(place.longitude, there.lon, 2);
  EXPECT_NEAR(place.height, there.alt / 1e3, 0.02);
}

TEST_F(PictureTest, TurnsNorthEastDownIntoEastNorthUp) {
  beat(false);
  auto moving = position({0, 0, 120});
  moving.vx = 300;
  moving.vy = 100;
  moving.vz = -50;
  moving.hdg = 9000;
  picture_.hear(moving, at(0));

  EXPECT_NEAR((picture_.state().velocity - world::Vector3(1, 3, 0.5)).norm(), 0, 1e-9);
  EXPECT_NEAR(picture_.state().heading, 0, 1e-9) << "east";
}

TEST_F(PictureTest, WithoutAHeadingTheAttitudeSaysIt) {
  auto without = position({0, 0, 120});
  without.hdg = 0xffff;
  picture_.hear(without, at(0));
  mavlink::Attitude north;
  picture_.hear(north);

  EXPECT_NEAR(picture_.state().heading, std::numbers::pi / 2, 1e-6);
}

TEST_F(PictureTest, HeightsAtTheEndsOfTheirRangeAreFigures) {
  mavlink::GlobalPositionInt far = position({0, 0, 120});
  far.alt = std::numeric_limits<std::int32_t>::max();
  far.relative_alt = std::numeric_limits<std::int32_t>::min();
  picture_.hear(far, at(0));

  EXPECT_NEAR(picture_.home_height(), 4'294'967.295, 1e-3);
  EXPECT_TRUE(picture_.state().position.allFinite());
}

TEST_F(PictureTest, NoFixIsNoPlace) {
  beat(false);
  picture_.hear(mavlink::GlobalPositionInt{}, at(0));
  auto nowhere = position({0, 0, 120});
  nowhere.lat = 1'200'000'000;
  picture_.hear(nowhere, at(0));

  EXPECT_FALSE(picture_.is_located(at(0)));
}

TEST_F(PictureTest, LinkAndPlaceGrowOld) {
  beat(false, 0);
  picture_.hear(position({0, 0, 120}), at(0));

  EXPECT_TRUE(picture_.is_located(at(2.9)));
  EXPECT_FALSE(picture_.is_located(at(3)));
  EXPECT_TRUE(picture_.is_linked(at(4.9)));
  EXPECT_FALSE(picture_.is_linked(at(5)));
}

TEST_F(PictureTest, AVehicleThatSaysNothingOfItsBatteryHasWhatItStartedWith) {
  picture_.hear_battery(-1);
  EXPECT_EQ(picture_.state().energy, 1);
  picture_.hear_battery(73);
  EXPECT_EQ(picture_.state().energy, 0.73);
  picture_.hear_battery(120);
  EXPECT_EQ(picture_.state().energy, 1);
}

TEST_F(PictureTest, WhatItSaysOfTheGroundCountsMoreThanHeights) {
  beat(true);
  picture_.hear(position({0, 0, 140}), at(0));
  picture_.hear(mavlink::ExtendedSysState{0, mav::kLandedOnGround});
  EXPECT_FALSE(picture_.state().airborne);
  picture_.hear(mavlink::ExtendedSysState{0, 4});
  EXPECT_TRUE(picture_.state().airborne);
}

}  // namespace
}  // namespace skein::autopilot
