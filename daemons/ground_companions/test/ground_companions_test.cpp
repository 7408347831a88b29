// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "skein/ground_companions/mavlink_station.hpp"
#include "skein/ground_companions/operators_page.hpp"
#include "skein/ground_companions/ros2_topics.hpp"

namespace skein::ground_companions {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class Companions : public ::testing::Test {
 protected:
  Companions() : scenario_(read()) {}

  static std::string file() {
    return std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/confirmed.yaml";
  }
  static scenario::Scenario read() {
    auto scenario = scenario::read_scenario(file());
    if (!scenario) ADD_FAILURE() << to_text(scenario.error());
    return scenario ? *scenario : scenario::Scenario();
  }

  /// As a daemon does, with this command line.
  Result<daemon_main::CompanionSource::Opened, Failure> open(daemon_main::CompanionSource& source,
                                                             const std::string& line) {
    CLI::App app;
    source.declare(app);
    app.parse(line);
    return source.open({file(), scenario_, network_});
  }

  scenario::Scenario scenario_;
  blackboard::NetworkConfig network_;
};

TEST_F(Companions, AreNotOpenedUnasked) {
  OperatorsPage page;
  MavlinkStation station;
  Ros2Topics topics;

  for (daemon_main::CompanionSource* source :
       {static_cast<daemon_main::CompanionSource*>(&page),
        static_cast<daemon_main::CompanionSource*>(&station),
        static_cast<daemon_main::CompanionSource*>(&topics)}) {
    const auto opened = open(*source, "");
    ASSERT_TRUE(opened.has_value());
    EXPECT_EQ(opened->companion, nullptr);
    EXPECT_EQ(opened->notice, "");
  }
}

TEST_F(Companions, ThePageSaysWhereItIs) {
  OperatorsPage page;

  const auto opened = open(page, "--console 127.0.0.1:0");

  ASSERT_TRUE(opened.has_value()) << opened.error().why;
  EXPECT_NE(opened->companion, nullptr);
  EXPECT_THAT(opened->notice, StartsWith("console at http://127.0.0.1:"));
}

TEST_F(Companions, APageThatCannotBeServedNamesItsOption) {
  OperatorsPage page;

  const auto opened = open(page, "--console 127.0.0.1:nowhere");

  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().why, StartsWith("--console: "));
}

TEST_F(Companions, AStationIsToldFromItsAddressOn) {
  MavlinkStation station;

  const auto opened = open(station, "--mavlink-out udp:127.0.0.1:14550 --geoid 47");

  ASSERT_TRUE(opened.has_value()) << opened.error().why;
  EXPECT_NE(opened->companion, nullptr);
  EXPECT_EQ(opened->notice, "telemetry by MAVLink to udp:127.0.0.1:14550");
}

TEST_F(Companions, AStationWithoutAnAddressNamesItsOption) {
  MavlinkStation station;

  const auto opened = open(station, "--mavlink-out carrier-pigeon");

  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().why, StartsWith("--mavlink-out: "));
}

TEST_F(Companions, AGeoidOutsideOfTheEarthIsRefusedByTheCommandLine) {
  MavlinkStation station;

  EXPECT_THROW((void)open(station, "--geoid 201"), CLI::ParseError);
}

}  // namespace
}  // namespace skein::ground_companions
