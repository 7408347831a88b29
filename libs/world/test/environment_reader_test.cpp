// SPDX-License-Identifier: Apache-2.0
#include "skein/world/environment_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/config/parse.hpp"

namespace skein::world {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A text that stays as long as what reads it.
class Text {
 public:
  explicit Text(const std::string& text) : value_(*config::parse_yaml(text, "e.yaml")) {}
  config::Reader reader() { return {value_, "e.yaml", diagnostics_}; }
  std::string report() const { return to_text(diagnostics_); }

 private:
  config::Value value_;
  Diagnostics diagnostics_;
};

TEST(EnvironmentReader, APointIsSoManyFiniteCoordinates) {
  Text right("[1.5, -2]"), wrong("[1, 2]"), far("[1, 2e6]");

  EXPECT_EQ(read_point_2d(right.reader()), Vector2(1.5, -2));
  EXPECT_EQ(right.report(), "");
  EXPECT_EQ(read_point(wrong.reader()), Vector3::Zero());
  EXPECT_THAT(wrong.report(), HasSubstr("this is not a point; expected [x, y, z] in metres"));
  EXPECT_EQ(read_point_2d(far.reader()), Vector2::Zero()) << "harmless, not half of it";
  EXPECT_THAT(far.report(), HasSubstr("e.yaml:1:5"));
}

TEST(EnvironmentReader, ANullInAPointIsNoZero) {
  Text text("[1, ~]");

  read_point_2d(text.reader());

  EXPECT_THAT(text.report(), HasSubstr("nothing in a point"));
}

TEST(EnvironmentReader, WindIsCalmWhenNothingIsSaid) {
  Text some("{speed: 4}"), wrong("{speed: 400, towards: 1}");

  EXPECT_EQ(read_wind(some.reader()), (Wind{0, 4, 0}));
  EXPECT_EQ(read_wind(some.reader().optional("absent")), Wind());
  EXPECT_EQ(some.report(), "");
  read_wind(wrong.reader());
  EXPECT_THAT(wrong.report(), HasSubstr("did you mean 'toward'?"));
  EXPECT_THAT(wrong.report(), HasSubstr("speed: "));
}

TEST(EnvironmentReader, ZonesAreSimplePolygonsInTheOrderWritten) {
  Text text("{b: [[0, 0], [9, 0], [9, 9]], a: [[0, 0], [9, 9], [9, 0], [0, 9]]}");

  const auto zones = read_zones(text.reader());

  ASSERT_THAT(zones, SizeIs(2));
  EXPECT_EQ(zones[0].name, "b");
  EXPECT_EQ(zones[1].name, "a");
  EXPECT_THAT(text.report(), HasSubstr("a: the edges after corner 1 and corner 3 cross or touch"));
}

TEST(EnvironmentReader, TerrainSaysAllItsProblems) {
  Text text("{west: 5, south: 0, east: 5, north: -1}");

  read_terrain(text.reader());

  EXPECT_THAT(text.report(), HasSubstr("east must be greater than west"));
  EXPECT_THAT(text.report(), HasSubstr("north must be greater than south"));
}

TEST(EnvironmentReader, AGeodeticPointHasAllItsFigures) {
  Text right("{latitude: 1, longitude: 2, altitude: 3}"), wrong("{latitude: 91, longitude: 2}");

  EXPECT_EQ(read_geodetic(right.reader()), (GeodeticPoint{1, 2, 3}));
  read_geodetic(wrong.reader());
  EXPECT_THAT(wrong.report(), HasSubstr("latitude: "));
  EXPECT_THAT(wrong.report(), HasSubstr("altitude: missing"));
}

TEST(EnvironmentReader, AnInstantIsNeverNegative) {
  Text right("12.5"), wrong("-1");

  EXPECT_EQ(read_instant(right.reader()), MissionTime::seconds(12.5));
  EXPECT_EQ(read_instant(right.reader().optional("x"), MissionTime::max()), MissionTime::max());
  read_instant(wrong.reader());
  EXPECT_NE(wrong.report(), "");
}

TEST(EnvironmentReader, WhatSaysNothingIsLeftOutAndReported) {
  Text list("[1, ~, 3]"), map("{a: 1, b: ~, '': 3}");

  EXPECT_THAT(items_of(list.reader()), SizeIs(2));
  EXPECT_THAT(list.report(), HasSubstr("nothing in a list"));
  EXPECT_THAT(entries_of(map.reader()), SizeIs(1));
  EXPECT_THAT(map.report(), HasSubstr("nothing is said of 'b'"));
  EXPECT_THAT(map.report(), HasSubstr("an empty name"));
}

}  // namespace
}  // namespace skein::world
