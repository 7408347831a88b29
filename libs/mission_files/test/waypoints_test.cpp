// SPDX-License-Identifier: Apache-2.0
// Way-point files as QGroundControl, Mission Planner and MAVProxy write them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "skein/mission_files/read.hpp"

namespace skein::mission_files {
namespace {

using ::testing::HasSubstr;

const std::string kHead = "QGC WPL 110\n";
const std::string kHome = "0\t1\t0\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t584.0\t1\n";

Contents contents_of(const std::string& text) {
  auto read = read_text(text, "m.waypoints");
  EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
  return read ? *read : Contents();
}
std::string errors_of(const std::string& text) {
  const auto read = read_text(text, "m.waypoints");
  EXPECT_FALSE(read);
  return read ? "" : to_text(read.error());
}

TEST(Waypoints, TheFirstLineOfArduPilotsFilesIsHome) {
  const Contents contents = contents_of(kHead + kHome + "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t20\t1\r\n" +
                                        "2\t0\t3\t16\t2.5\t0\t0\t0\t-35.3620\t149.1650\t25\t1\r\n" +
                                        "3\t0\t3\t21\t0\t0\t0\t0\t-35.3621\t149.1651\t0\t1\r\n");

  ASSERT_TRUE(contents.home);
  EXPECT_EQ(contents.home->at, (LatLon{-35.3632621, 149.1652374}));
  EXPECT_EQ(contents.home->over_sea, 584);
  ASSERT_EQ(contents.items.size(), 3U);
  EXPECT_EQ(std::get<TakeOff>(contents.items[0].step).to.metres, 20);
  EXPECT_EQ(std::get<FlyTo>(contents.items[1].step).hold, 2.5);
  EXPECT_EQ(std::get<Land>(contents.items[2].step).at, (LatLon{-35.3621, 149.1651}));
  EXPECT_EQ(contents.items[2].mark.line, 5);
}

TEST(Waypoints, TheFirstItemOfOthersIsAnItem) {
  const Contents contents = contents_of(kHead + "0 1 3 22 0 0 0 0 47.1 8.1 20 1\n");

  EXPECT_FALSE(contents.home);
  EXPECT_EQ(contents.items.size(), 1U);
}

TEST(Waypoints, EveryErrorIsToldAtOnceWithItsLine) {
  const std::string errors = errors_of(kHead + kHome + "1\t0\t3\t16\t0\t0\t0\t0\t47\t8\t25\n" +
                                       "2\t0\t3\tx\t0\t0\t0\t0\t47\t8\tfar\t1\n" +
                                       "3\t0\t3\t16\t0\t0\t0\t0\t47\t181\t25\t1\n");

  EXPECT_THAT(errors, HasSubstr("m.waypoints:3: 11 columns; expected 12 columns"));
  EXPECT_THAT(errors, HasSubstr("m.waypoints:4: column 4: 'x'; expected a whole number"));
  EXPECT_THAT(errors, HasSubstr("m.waypoints:4: column 11: 'far'; expected a number"));
  EXPECT_THAT(errors, HasSubstr("m.waypoints:5: latitude 47"));
}

TEST(Waypoints, AnotherVersionIsRefused) {
  EXPECT_THAT(errors_of("QGC WPL 120\n" + kHome), HasSubstr("'QGC WPL 120'; expected QGC WPL 110"));
}

TEST(Waypoints, AFileWithNothingInItIsRefused) {
  EXPECT_THAT(errors_of(kHead), HasSubstr("there is nothing in it"));
}

TEST(Waypoints, ThatAMissionStopsAtAnItemIsTold) {
  const Contents contents = contents_of(kHead + "0 1 3 22 0 0 0 0 0 0 20 0\n");

  EXPECT_THAT(to_text(contents.left_out), HasSubstr("NAV_TAKEOFF (22): that the mission stops"));
}

TEST(Waypoints, TenThousandItemsAreReadAndNoMore) {
  std::string text = kHead;
  for (int i = 0; i < 10'000; ++i) text += "1 0 3 16 0 0 0 0 47 8 25 1\n";

  EXPECT_EQ(contents_of(text).items.size(), 10'000U);
  EXPECT_THAT(errors_of(text + "1 0 3 16 0 0 0 0 47 8 25 1\n"),
              HasSubstr("m.waypoints:10002: more than 10000 items"));
}

RC_GTEST_PROP(Waypoints, WhatIsWrittenIsRead, ()) {
  const auto e7 = [](std::int64_t most) {
    return static_cast<double>(*rc::gen::inRange(-most, most)) / 1e7;
  };
  const LatLon at{e7(900'000'000), e7(1'800'000'000)};
  RC_PRE(at.latitude != 0 || at.longitude != 0);
  const double height = static_cast<double>(*rc::gen::inRange(-500'000, 5'000'000)) / 1000;
  std::ostringstream line;
  line.precision(12);
  line << "7\t0\t10\t16\t0\t0\t0\t0\t" << at.latitude << '\t' << at.longitude << '\t' << height
       << "\t1\n";

  const auto read = read_text(kHead + line.str(), "m.waypoints");

  RC_ASSERT(read.has_value());
  const Position& to = std::get<FlyTo>(read->items.at(0).step).to;
  RC_ASSERT(std::abs(to.at.latitude - at.latitude) < 1e-9);
  RC_ASSERT(std::abs(to.at.longitude - at.longitude) < 1e-9);
  RC_ASSERT(std::abs(to.height->metres - height) < 1e-6);
}

}  // namespace
}  // namespace skein::mission_files
