// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_out/announcer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "skein/mavlink/parser.hpp"

namespace skein::mavlink_out {
namespace {

using mavlink::BatteryStatus;
using mavlink::Frame;
using mavlink::GlobalPositionInt;
using mavlink::StatusText;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Duration s(double seconds) { return Duration::seconds(seconds); }

class Announced : public ::testing::Test {
 protected:
  static AnnouncerConfig config() {
    AnnouncerConfig config;
    config.vehicles = {{"marvin", world::VehicleKind::kHelicopter, 12},
                       {"karma", world::VehicleKind::kBlimp, 0}};
    config.origin = {47.5, 8.25, 400};
    config.geoid = 48;
    return config;
  }
  static Heard heard(const std::string& name, double at = 1) {
    Heard one;
    one.name = name;
    one.at = MissionTime::seconds(at);
    one.position = {100, 200, 42};
    one.velocity = {3, 4, -1};
    one.heading = 0;
    one.energy = 0.755;
    one.airborne = true;
    return one;
  }
  std::vector<Frame> turn(double now) {
    std::vector<Frame> frames;
    mavlink::Parser parser;
    for (const auto& bytes : announcer_.turn(s(now)))
      for (const Frame& frame : parser.take(bytes)) frames.push_back(frame);
    return frames;
  }
  template <class Type>
  static std::vector<Type> all(const std::vector<Frame>& frames, int system) {
    std::vector<Type> found;
    for (const Frame& frame : frames) {
      const auto message = mavlink::to_message(frame);
      if (frame.from.system != system || !message) continue;
      if (const auto* one = std::get_if<Type>(&*message)) found.push_back(*one);
    }
    return found;
  }
  template <class Type>
  static Type only(const std::vector<Frame>& frames, int system) {
    const auto found = all<Type>(frames, system);
    EXPECT_THAT(found, SizeIs(1));
    return found.empty() ? Type() : found.front();
  }

  Announcer announcer_{config()};
};

TEST_F(Announced, NothingIsToldOfWhoWasNotHeard) { EXPECT_THAT(turn(0), IsEmpty()); }

TEST_F(Announced, EachVehicleIsASystemOfItsOwn) {
  announcer_.hear(heard("karma"), s(0));
  announcer_.hear(heard("marvin"), s(0));

  const auto frames = turn(0);

  EXPECT_EQ(only<mavlink::Heartbeat>(frames, 1).type, 4) << "MAV_TYPE_HELICOPTER";
  EXPECT_EQ(only<mavlink::Heartbeat>(frames, 2).type, 7) << "MAV_TYPE_AIRSHIP";
  for (const Frame& frame : frames) EXPECT_EQ(frame.from.component, 1);
}

TEST_F(Announced, APositionIsOnEarthOverTheSeaAndOverHome) {
  announcer_.hear(heard("marvin", 2.5), s(0));

  const auto position = only<GlobalPositionInt>(turn(0), 1);

  // By the radii of curvature of WGS 84 at 47.5 degrees.
  EXPECT_NEAR(position.lat, 475'000'000 + 200 / 111'182.0 * 1e7, 30);
  EXPECT_NEAR(position.lon, 82'500'000 + 100 / 75'344.0 * 1e7, 30);
  EXPECT_NEAR(position.alt, (400 + 42 - 48) * 1000, 10);
  EXPECT_EQ(position.relative_alt, 30'000);
  EXPECT_EQ(position.vx, 400) << "north";
  EXPECT_EQ(position.vy, 300) << "east";
  EXPECT_EQ(position.vz, 100) << "down";
  EXPECT_EQ(position.hdg, 9000) << "east";
  EXPECT_EQ(position.time_boot_ms, 2500U);
}

TEST_F(Announced, HeadingsTurnClockwiseFromNorth) {
  const double pi = std::numbers::pi;
  const std::vector<std::pair<double, int>> cases{
      {pi / 2, 0}, {0, 9000}, {-pi / 2, 18'000}, {pi, 27'000}, {5 * pi / 2, 0}};
  double now = 0;
  for (const auto& [heading, meant] : cases) {
    Heard one = heard("marvin", ++now);
    one.heading = heading;
    announcer_.hear(one, s(now));
    const auto frames = turn(now);
    EXPECT_EQ(only<GlobalPositionInt>(frames, 1).hdg, meant) << heading;
    const double yaw = only<mavlink::Attitude>(frames, 1).yaw;
    EXPECT_NEAR(std::remainder(yaw * 18'000 / pi - meant, 36'000), 0, 0.1) << heading;
  }
}

TEST_F(Announced, BatteryAndWhetherItFliesAreTold) {
  announcer_.hear(heard("marvin"), s(0));
  auto frames = turn(0);
  EXPECT_EQ(only<BatteryStatus>(frames, 1).battery_remaining, 76);
  EXPECT_EQ(only<BatteryStatus>(frames, 1).voltages[0], 0xffff) << "no voltage is known";
  EXPECT_EQ(only<mavlink::SysStatus>(frames, 1).battery_remaining, 76);
  EXPECT_EQ(only<mavlink::ExtendedSysState>(frames, 1).landed_state, 2);
  EXPECT_EQ(only<mavlink::Heartbeat>(frames, 1).base_mode & 0x80, 0x80);

  Heard down = heard("marvin", 2);
  down.airborne = false;
  announcer_.hear(down, s(1));
  frames = turn(1);
  EXPECT_EQ(only<mavlink::ExtendedSysState>(frames, 1).landed_state, 1);
  EXPECT_EQ(only<mavlink::Heartbeat>(frames, 1).base_mode & 0x80, 0);
  EXPECT_EQ(only<mavlink::Heartbeat>(frames, 1).system_status, 3);
}

TEST_F(Announced, TroubleOnBoardIsACriticalState) {
  Heard one = heard("marvin");
  one.in_trouble = true;
  announcer_.hear(one, s(0));

  EXPECT_EQ(only<mavlink::Heartbeat>(turn(0), 1).system_status, 5);
}

TEST_F(Announced, AHeartbeatComesOnceASecondUntilTheVehicleFallsSilent) {
  announcer_.hear(heard("marvin"), s(0));
  std::vector<double> beats;
  for (int i = 0; i < 100; ++i)
    if (const double now = i / 10.0; !all<mavlink::Heartbeat>(turn(now), 1).empty())
      beats.push_back(now);

  EXPECT_THAT(beats, ElementsAre(0, 1, 2));
}

TEST_F(Announced, PositionsGoOutAsTheyComeButFiveASecondAtMost) {
  std::size_t positions = 0;
  for (int i = 0; i < 200; ++i) {
    const double now = i / 20.0;
    announcer_.hear(heard("marvin", now), s(now));
    positions += all<GlobalPositionInt>(turn(now), 1).size();
  }
  EXPECT_EQ(positions, 50U);

  EXPECT_THAT(all<GlobalPositionInt>(turn(10.2), 1), SizeIs(1)) << "the last that was heard";
  EXPECT_THAT(all<GlobalPositionInt>(turn(10.5), 1), IsEmpty()) << "nothing new was heard";
}

TEST_F(Announced, WhatIsOlderThanWhatWasHeardDoesNotCount) {
  announcer_.hear(heard("marvin", 5), s(0));
  Heard old = heard("marvin", 4);
  old.energy = 0.1;
  announcer_.hear(old, s(0.5));

  EXPECT_EQ(only<BatteryStatus>(turn(0.5), 1).battery_remaining, 76);
}

TEST_F(Announced, WordsAreSaidInTheNameOfTheVehicleOrOfTheFirstThatIsHeard) {
  announcer_.hear(heard("karma"), s(0));
  announcer_.say("karma", Severity::kWarning, "refuses START");
  announcer_.say("", Severity::kError, "alarm 1 raised");
  announcer_.say("marvin", Severity::kInfo, "not heard yet");

  const auto texts = all<StatusText>(turn(0), 2);

  ASSERT_THAT(texts, SizeIs(2));
  EXPECT_EQ(mavlink::text_of(texts[0]), "refuses START");
  EXPECT_EQ(texts[0].severity, 4);
  EXPECT_EQ(mavlink::text_of(texts[1]), "alarm 1 raised");
  announcer_.hear(heard("marvin"), s(1));
  EXPECT_EQ(mavlink::text_of(only<StatusText>(turn(1), 1)), "not heard yet");
}

TEST_F(Announced, LongWordsComeInPiecesOfOneNumber) {
  std::string text;
  for (int i = 0; i < 12; ++i) text += "0123456789";
  announcer_.hear(heard("marvin"), s(0));
  announcer_.say("marvin", Severity::kInfo, text);

  std::string together;
  int pieces = 0;
  for (const StatusText& one : all<StatusText>(turn(0), 1)) {
    EXPECT_EQ(one.chunk_seq, pieces++);
    EXPECT_EQ(one.id, 1);
    together += mavlink::text_of(one);
  }
  EXPECT_EQ(pieces, 3);
  EXPECT_EQ(together, text);
}

TEST_F(Announced, WordsWithoutEndAreCutAndWordsWithoutNumberAreDropped) {
  for (int i = 0; i < 10'000; ++i)
    announcer_.say("marvin", Severity::kInfo, std::string(1000, 'a') + std::to_string(i));
  announcer_.hear(heard("marvin"), s(0));

  EXPECT_EQ(all<StatusText>(turn(0), 1).size(), 64U * 4U);
  EXPECT_THAT(all<StatusText>(turn(1), 1), IsEmpty());
}

TEST_F(Announced, FiguresThatAreNoneAreNotHeard) {
  Heard one = heard("marvin");
  one.position.x() = std::numeric_limits<double>::quiet_NaN();
  announcer_.hear(one, s(0));
  announcer_.hear(heard("nobody"), s(0));

  EXPECT_THAT(turn(0), IsEmpty());
}

TEST_F(Announced, AMissionThatRunsSlowlyIsWaitedForLonger) {
  AnnouncerConfig slow = config();
  slow.rate = 0.1;
  announcer_ = Announcer(slow);
  announcer_.hear(heard("marvin"), s(0));

  EXPECT_THAT(all<mavlink::Heartbeat>(turn(20), 1), SizeIs(1));
  EXPECT_THAT(turn(31), IsEmpty());
}

}  // namespace
}  // namespace skein::mavlink_out
