// SPDX-License-Identifier: Apache-2.0
#include "airspace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "skein/geodata/shapes.hpp"
#include "skein/mission_files/read.hpp"
#include "skein/world/polygon_check.hpp"
#include "temporary_folder.hpp"

namespace skein::import_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using world::Polygon;
using world::Vector2;

constexpr world::GeodeticOrigin kOrigin{47.5, 8.25, 430};
const Sides kSides{-2000, -2000, 2000, 2000};

world::TerrainSpec level(double base = 0) {
  world::TerrainSpec spec;
  spec.west = spec.south = -1000;
  spec.east = spec.north = 1000;
  spec.base = base;
  return spec;
}

const Site& site() {
  static const Site kSite(kOrigin, level(), {47.5, 8.25}, 430.0, std::nullopt);
  return kSite;
}

struct Read {
  Airspace air;
  Log log{"test"};
};

Read read_kml(const std::string& features, const std::vector<std::string>& closed = {}) {
  const auto contents = mission_files::read_text("<kml>" + features + "</kml>", "a.kml");
  EXPECT_TRUE(contents) << (contents ? "" : to_text(contents.error()));
  Read read;
  Names names;
  if (contents) read.air = airspace_of(*contents, closed, site(), kSides, names, read.log);
  return read;
}

std::string placemark(const std::string& name, const std::string& more = "",
                      const std::string& coordinates = "8.25,47.5,60 8.26,47.5,60 8.26,47.51,60") {
  return "<Placemark><name>" + name + "</name><Polygon>" + more +
         "<outerBoundaryIs><LinearRing><coordinates>" + coordinates +
         "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>";
}

mission_files::Contents fences(std::vector<mission_files::Fence> all) {
  mission_files::Contents contents;
  contents.fences = std::move(all);
  return contents;
}

Airspace read_fences(std::vector<mission_files::Fence> all, Log& log) {
  Names names;
  return airspace_of(fences(std::move(all)), {}, site(), kSides, names, log);
}

TEST(Airspace, AnAreaIsAZoneUnlessItsNameOrItsFolderSaysThatItIsClosed) {
  const Read read = read_kml(placemark("field") + placemark("No-Fly") +
                             "<Folder><name>Fences</name>" + placemark("mast") + "</Folder>");

  ASSERT_THAT(read.air.zones, SizeIs(1));
  EXPECT_EQ(read.air.zones[0].name, "field");
  ASSERT_THAT(read.air.closed, SizeIs(2));
  EXPECT_EQ(read.air.closed[0].name, "No-Fly");
  EXPECT_EQ(read.air.closed[1].name, "mast");
}

TEST(Airspace, NamesOfClosedAirCanBeGiven) {
  const Read read = read_kml(placemark("R-12"), {"r-12"});

  EXPECT_THAT(read.air.zones, SizeIs(0));
  EXPECT_THAT(read.air.closed, SizeIs(1));
}

TEST(Airspace, WhatStandsOnTheGroundIsClosedUpToItsTop) {
  const Read read = read_kml(
      placemark("fence", "<extrude>1</extrude><altitudeMode>relativeToGround</altitudeMode>"));

  ASSERT_THAT(read.air.closed, SizeIs(1));
  EXPECT_NEAR(read.air.closed[0].ceiling, 60, 0.01);
  EXPECT_TRUE(std::isinf(read.air.closed[0].floor));
}

TEST(Airspace, ATopOverTheGroundCountsFromTheHighestGroundInside) {
  world::TerrainSpec spec = level();
  spec.hills = {{{300, 300}, 80, 100}};
  const Site hilly(kOrigin, spec, {47.5, 8.25}, 430.0, std::nullopt);
  const auto contents = mission_files::read_text(
      "<kml>" +
          placemark("fence", "<extrude>1</extrude><altitudeMode>relativeToGround</altitudeMode>",
                    "8.252,47.501,60 8.256,47.501,60 8.256,47.505,60 8.252,47.505,60") +
          "</kml>",
      "a.kml");
  ASSERT_TRUE(contents);
  Log log("test");
  Names names;

  const Airspace air = airspace_of(*contents, {}, hilly, kSides, names, log);

  ASSERT_THAT(air.closed, SizeIs(1));
  EXPECT_NEAR(air.closed[0].ceiling, 140, 3) << "the hill's top is between corners of the grid";
}

TEST(Airspace, MorePiecesOfClosedAirThanCanBeHeldAgainstAFlightAreRefused) {
  std::vector<mission_files::Fence> many;
  for (int i = 0; i < 600; ++i)
    many.push_back({mission_files::Circle{{47.5, 8.25}, 10}, false, {i, ""}});
  Log log("test");

  const Airspace air = read_fences(many, log);

  EXPECT_THAT(air.closed, SizeIs(500));
  EXPECT_EQ(to_text(log.errors()), "test:500: more than 500 pieces of closed air\n");
}

TEST(Airspace, MoreCornersThanAScenarioHasRoomForAreRefusedOnce) {
  mission_files::Contents contents;
  mission_files::Area area;
  for (int i = 0; i < 1500; ++i) {
    const double angle = 2 * std::numbers::pi * i / 1500;
    area.ring.push_back({47.5 + 0.01 * std::sin(angle), 8.25 + 0.01 * std::cos(angle)});
  }
  for (int i = 0; i < 140; ++i) {
    area.mark.line = i + 1;
    contents.areas.push_back(area);
  }
  Log log("test");
  Names names;

  airspace_of(contents, {}, site(), kSides, names, log);

  EXPECT_EQ(to_text(log.errors()), "test:134: more than 200000 corners\n");
}

TEST(Airspace, HeightsOverTheSeaCountFromHomesHeight) {
  const Read read =
      read_kml(placemark("fence", "<extrude>1</extrude><altitudeMode>absolute</altitudeMode>",
                         "8.25,47.5,500 8.2501,47.5,500 8.2501,47.5001,500"));

  ASSERT_THAT(read.air.closed, SizeIs(1));
  EXPECT_NEAR(read.air.closed[0].ceiling, 70, 0.01);  // home: 430 m over the sea, at z = 0
}

TEST(Airspace, CornersThatCrossAreRefusedWithTheirLine) {
  const Read read =
      read_kml("\n" + placemark("bow", "", "8.25,47.5 8.26,47.51 8.26,47.5 8.25,47.51"));

  EXPECT_THAT(to_text(read.log.errors()), HasSubstr("test:2: Polygon 'bow': "));
}

/// GDAL reads the same file.
TEST(Airspace, CornersLieWhereGdalPutsThem) {
  const skein::testing::TemporaryFolder folder;
  const std::string file = (folder.path() / "a.kml").string();
  const std::string features =
      placemark("a", "", "8.241,47.493 8.262,47.492 8.2613,47.5085 8.2405,47.507");
  std::ofstream(file) << "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>" << features
                      << "</Document></kml>";

  const Read read = read_kml(features);
  const auto theirs = geodata::read_shapes(file, kOrigin);

  ASSERT_TRUE(theirs) << to_text(theirs.error());
  ASSERT_THAT(*theirs, SizeIs(1));
  ASSERT_THAT(read.air.zones, SizeIs(1));
  const Polygon& ours = read.air.zones[0].polygon;
  ASSERT_EQ(ours.size(), theirs->at(0).outer.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
    EXPECT_LT((ours[i] - theirs->at(0).outer[i]).norm(), 1e-3) << "corner " << i;
}

TEST(Airspace, AnExclusionIsClosedAndACircleWithAllThatIsInIt) {
  Log log("test");
  const Airspace air = read_fences({{mission_files::Circle{{47.5, 8.25}, 100}, false, {}}}, log);

  ASSERT_THAT(air.closed, SizeIs(1));
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180;
    EXPECT_TRUE(world::contains(air.closed[0].polygon,
                                Vector2(99.99 * std::cos(angle), 99.99 * std::sin(angle))));
  }
}

TEST(Airspace, AllThatIsOutsideOfAnInclusionIsClosed) {
  Log log("test");
  const Airspace air = read_fences({{mission_files::Circle{{47.5, 8.25}, 100}, true, {}}}, log);

  const auto closed = [&](const Vector2& at) {
    return std::any_of(air.closed.begin(), air.closed.end(),
                       [&](const auto& volume) { return world::contains(volume.polygon, at); });
  };
  EXPECT_FALSE(closed({0, 0}));
  EXPECT_FALSE(closed({95, 0}));
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180;
    EXPECT_TRUE(closed({100.01 * std::cos(angle), 100.01 * std::sin(angle)})) << i;
  }
}

TEST(Airspace, SeveralInclusionsAreLeftOutAndTold) {
  Log log("test");
  const mission_files::Circle circle{{47.5, 8.25}, 100};
  const Airspace air = read_fences({{circle, true, {3, "a"}}, {circle, true, {4, "b"}}}, log);

  EXPECT_THAT(air.closed, SizeIs(0));
  EXPECT_EQ(log.left_out().size(), 2U);
  EXPECT_THAT(to_text(log.left_out()), HasSubstr("autopilots differ"));
}

/// Around the origin, at random distances: simple, and anything but convex.
Polygon star() {
  const int corners = *rc::gen::inRange(3, 20);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners + 0.1;
    const double distance = *rc::gen::inRange(20, 900);
    polygon.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
  }
  if (*rc::gen::arbitrary<bool>()) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

RC_GTEST_PROP(OutsideOf, APointIsInTheInclusionOrInWhatIsOutsideOfIt, ()) {
  const Polygon inside = star();
  RC_PRE(!world::problem_of(inside));

  const auto outside = outside_of(inside, kSides);

  RC_ASSERT(outside.size() == 2);
  double areas = world::area(inside);
  for (const Polygon& part : outside) {
    RC_ASSERT(!world::problem_of(part));
    areas += world::area(part);
  }
  RC_ASSERT(std::abs(areas - 4000.0 * 4000.0) < 1);
  for (int i = 0; i < 50; ++i) {
    const Vector2 at(*rc::gen::inRange(-19990, 19990) / 10.0 + 0.0123,
                     *rc::gen::inRange(-19990, 19990) / 10.0 + 0.0321);
    const int in = static_cast<int>(world::contains(inside, at)) +
                   static_cast<int>(world::contains(outside[0], at)) +
                   static_cast<int>(world::contains(outside[1], at));
    RC_ASSERT(in == 1);
  }
}

}  // namespace
}  // namespace skein::import_tool
