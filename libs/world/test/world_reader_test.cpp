// SPDX-License-Identifier: Apache-2.0
#include "skein/world/world_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::world {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kHills = R"(origin: {latitude: 37.5, longitude: -6, altitude: 150}
terrain:
  west: -500
  south: -400
  east: 600
  north: 700
  cell: 10
  base: 2
  hills: [{at: [100, 50], height: 60, radius: 200}]
wind: {toward: 1, speed: 4, gusts: 0.5}
airspace: {floor: 0, ceiling: 200, voxel: 10}
no_fly:
  village: {polygon: [[0, 0], [100, 0], [100, 100]], floor: 10, ceiling: 80, from: 60, until: 90}
  tower: {polygon: [[300, 300], [310, 300], [310, 310]]}
zones:
  forest: [[0, 0], [50, 0], [50, 50]]
places:
  base: [1, 2, 3]
  chapel: {latitude: 37.6, longitude: -6.1, altitude: 200}
ground:
  cell: 20
  risk: {base: 0.1, peaks: [{at: [100, 100], risk: 0.9, radius: 300}]}
  mapped: [[[0, 0], [50, 0], [50, 50]]]
  alarms: [[10, 20]]
  fires: [[30, 40], [50, 60]]
radio: {range: 800, line_of_sight: false, latency: 0.1, loss: 0.2, hysteresis: 0.1}
)";

const std::string kRaster = R"(terrain: {raster: dem.tif}
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// What is wrong with a text, as the user reads it; "" if nothing.
std::string report(const std::string& text) {
  const auto world = read_world_file(text, "w.yaml");
  return world ? "" : to_text(world.error());
}

/// The file with one thing changed.
std::string report(const std::string& from, const std::string& to) {
  return report(replaced(kHills, from, to));
}

WorldFile read(const std::string& text) {
  auto world = read_world_file(text, "w.yaml");
  EXPECT_TRUE(world) << to_text(world.error());
  return world ? *world : WorldFile();
}

TEST(WorldReader, ReadsTheGroundAndTheWind) {
  const WorldFile world = read(kHills);

  EXPECT_EQ(world.origin, (GeodeticOrigin{37.5, -6, 150}));
  const auto& terrain = std::get<TerrainSpec>(world.terrain);
  EXPECT_EQ(terrain.west, -500);
  EXPECT_EQ(terrain.north, 700);
  EXPECT_EQ(terrain.base, 2);
  ASSERT_THAT(terrain.hills, SizeIs(1));
  EXPECT_EQ(terrain.hills[0].at, Vector2(100, 50));
  EXPECT_EQ(world.wind, (Wind{1, 4, 0.5}));
}

TEST(WorldReader, ReadsVolumesWithTheirWindows) {
  const WorldFile world = read(kHills);

  ASSERT_THAT(world.volumes, SizeIs(2));
  const Volume& village = world.volumes[0];
  EXPECT_EQ(village.name, "village");
  EXPECT_EQ(village.polygon, (Polygon{{0, 0}, {100, 0}, {100, 100}}));
  EXPECT_EQ(village.floor, 10);
  EXPECT_EQ(village.ceiling, 80);
  EXPECT_EQ(village.when, (TimeWindow{MissionTime::seconds(60), MissionTime::seconds(90)}));
  EXPECT_EQ(world.volumes[1].ceiling, std::numeric_limits<double>::infinity());
  EXPECT_EQ(world.volumes[1].when, TimeWindow());
}

TEST(WorldReader, ReadsNamesOfAreasAndPoints) {
  const WorldFile world = read(kHills);

  ASSERT_THAT(world.zones, SizeIs(1));
  EXPECT_EQ(world.zones[0].name, "forest");
  EXPECT_EQ(std::get<Vector3>(world.places.at("base").at), Vector3(1, 2, 3));
  EXPECT_EQ(std::get<GeodeticPoint>(world.places.at("chapel").at),
            (GeodeticPoint{37.6, -6.1, 200}));
  EXPECT_EQ(world.places.at("chapel").mark.line, 19);
  EXPECT_EQ(world.places.at("chapel").mark.path, "places.chapel");
}

TEST(WorldReader, ReadsTheStateOfTheGround) {
  const GroundRequest ground = read(kHills).ground;

  EXPECT_EQ(ground.cell, 20);
  const auto& peaks = std::get<RiskPeaks>(ground.risk);
  EXPECT_EQ(peaks.base, 0.1);
  ASSERT_THAT(peaks.peaks, SizeIs(1));
  EXPECT_EQ(peaks.peaks[0].risk, 0.9);
  EXPECT_THAT(ground.mapped, SizeIs(1));
  EXPECT_THAT(ground.alarms, ElementsAre(Vector2(10, 20)));
  EXPECT_THAT(ground.fires, ElementsAre(Vector2(30, 40), Vector2(50, 60)));
}

TEST(WorldReader, ReadsTheRadio) {
  const RadioModel radio = read(kHills).radio;

  EXPECT_EQ(radio.range, 800);
  EXPECT_FALSE(radio.needs_line_of_sight);
  EXPECT_EQ(radio.latency, Duration::milliseconds(100));
  EXPECT_EQ(radio.loss, 0.2);
  EXPECT_EQ(radio.hysteresis, 0.1);
  EXPECT_FALSE(radio.budget);
}

TEST(WorldReader, ALinkBudgetTakesThePlaceOfARange) {
  const std::string budget = "radio: {power: 27, sensitivity: -95, exponent: 2.5}";
  const WorldFile world = read(kRaster + budget);

  EXPECT_EQ(world.radio.budget, (LinkBudget{27, -95, 40, 2.5}));
  EXPECT_THAT(report(kRaster + "radio: {power: 27, sensitivity: -95, range: 100}"),
              HasSubstr("w.yaml:2:45: radio.range: a range beside a link budget"));
  EXPECT_THAT(report(kRaster + "radio: {sensitivity: -95}"),
              HasSubstr("radio.sensitivity: sensitivity without power"));
  EXPECT_THAT(report(kRaster + "radio: {power: 27}"), HasSubstr("radio.sensitivity: missing"));
}

TEST(WorldReader, ReadsWhereARasterIsAndHowItIsTaken) {
  const WorldFile world = read(R"(terrain:
  raster: data/dem.asc
  crs: EPSG:4326
  nodata: 12
  cell: 30
  west: -1
  south: -2
  east: 3
  north: 4
ground: {risk: {raster: risk.tif, nodata: 0}}
)");

  EXPECT_FALSE(world.origin) << "that of the raster";
  const auto& terrain = std::get<RasterTerrain>(world.terrain);
  EXPECT_EQ(terrain.raster.file, "data/dem.asc");
  EXPECT_EQ(terrain.raster.crs, "EPSG:4326");
  EXPECT_EQ(terrain.raster.no_data, 12);
  EXPECT_EQ(terrain.raster.mark.line, 2);
  EXPECT_EQ(terrain.cell, 30);
  EXPECT_EQ(terrain.extent, (Extent{-1, -2, 3, 4}));
  EXPECT_EQ(std::get<RasterSource>(world.ground.risk).file, "risk.tif");
}

TEST(WorldReader, WhatIsLeftOutHasItsDefault) {
  const WorldFile world = read(kRaster);

  const auto& terrain = std::get<RasterTerrain>(world.terrain);
  EXPECT_FALSE(terrain.cell);
  EXPECT_FALSE(terrain.extent);
  EXPECT_FALSE(terrain.raster.no_data);
  EXPECT_EQ(world.wind, Wind());
  EXPECT_FALSE(world.airspace.voxel);
  EXPECT_THAT(world.volumes, IsEmpty());
  EXPECT_EQ(std::get<double>(world.ground.risk), 0.5);
  EXPECT_EQ(world.radio.range, 10'000);
  EXPECT_TRUE(world.radio.needs_line_of_sight);
}

TEST(WorldReader, HillsNeedAnOrigin) {
  EXPECT_THAT(report("origin: {latitude: 37.5, longitude: -6, altitude: 150}\n", ""),
              HasSubstr("origin: missing"));
}

TEST(WorldReader, UnknownKeysAreRefusedWithTheNearest) {
  EXPECT_THAT(report("no_fly:", "nofly:"), HasSubstr("did you mean 'no_fly'?"));
  EXPECT_THAT(report("ceiling: 80", "cieling: 80"), HasSubstr("did you mean 'ceiling'?"));
  EXPECT_THAT(report(kRaster + "ground: {risk: {raster: a, no_data: 0}}"),
              HasSubstr("did you mean 'nodata'?"));
  EXPECT_THAT(report("terrain: {raster: dem.tif, hills: []}"), HasSubstr("unknown key 'hills'"));
}

TEST(WorldReader, EveryErrorIsGivenAtOnceWithItsPlace) {
  std::string text = replaced(kHills, "latitude: 37.5", "latitude: 97.5");
  text = replaced(text, "radius: 200", "radius: 0");
  text = replaced(text, "voxel: 10", "voxel: nan");
  text = replaced(text, "until: 90", "until: 30");
  text = replaced(text, "risk: 0.9", "risk: 9");

  const auto world = read_world_file(text, "w.yaml");

  ASSERT_FALSE(world);
  std::vector<std::string> paths;
  for (const Diagnostic& d : world.error().all()) {
    paths.push_back(d.path);
    EXPECT_EQ(d.file, "w.yaml");
    EXPECT_GT(d.line, 0);
  }
  EXPECT_THAT(paths, ElementsAre("terrain.hills[0].radius", "origin.latitude", "airspace.voxel",
                                 "no_fly.village", "ground.risk.peaks[0].risk"));
}

TEST(WorldReader, WrongFiguresAndContradictionsAreRefused) {
  struct Case {
    const char* from;
    const char* to;
    const char* error;
  };
  const Case cases[] = {
      {"cell: 10", "cell: 0", "terrain.cell"},
      {"east: 600", "east: -600", "terrain: terrain: east must be greater than west"},
      {"north: 700", "north: .inf", "terrain.north"},
      {"speed: 4", "speed: -4", "wind.speed"},
      {"floor: 10, ceiling: 80", "floor: 90, ceiling: 80", "the ceiling is not above the floor"},
      {"from: 60", "from: -1", "no_fly.village.from"},
      {"[100, 0], [100, 100]]", "[100, 0]]", "no_fly.village.polygon: 2 corners"},
      {"[[0, 0], [100, 0], [100, 100]]", "[[0, 0], [9, 9], [9, 0], [0, 9]]", "cross or touch"},
      {"[[0, 0], [50, 0], [50, 50]]", "[[0, 0], [50, 0], [50]]", "zones.forest[2]: this is not"},
      {"[[0, 0], [50, 0], [50, 50]]", "[[0, 0], [50, 0], [50, ~]]", "nothing in a point"},
      {"[[0, 0], [50, 0], [50, 50]]", "[[0, 0], ~, [50, 0], [5, 5]]", "nothing in a list"},
      {"[[0, 0], [50, 0], [50, 50]]", "7", "zones.forest: "},
      {"forest: [[0", "'': [[0", "an empty name"},
      {"base: [1, 2, 3]", "base: [1, 2]", "places.base: this is not a point"},
      {"base: [1, 2, 3]", "base: [1, 2, 1e9]", "places.base[2]"},
      {"base: [1, 2, 3]", "base:", "nothing is said of 'base'"},
      {"longitude: -6.1", "longitude: -600", "places.chapel.longitude"},
      {"cell: 20", "cell: 0.001", "ground.cell"},
      {"base: 0.1", "base: -0.1", "ground.risk.base"},
      {"range: 800", "range: 0", "radio.range"},
      {"loss: 0.2", "loss: 1", "radio.loss"},
      {"line_of_sight: false", "line_of_sight: maybe", "radio.line_of_sight"},
  };
  for (const Case& c : cases) EXPECT_THAT(report(c.from, c.to), HasSubstr(c.error)) << c.to;
}

TEST(WorldReader, AWrongCornerIsNotAlsoAWrongPolygon) {
  const auto world = read_world_file(
      replaced(kHills, "[[0, 0], [50, 0], [50, 50]]", "[[0, 0], [5, 0], [x, 5]]"), "w.yaml");

  ASSERT_FALSE(world);
  EXPECT_THAT(world.error().all(), SizeIs(1));
}

TEST(WorldReader, RastersNeedNamesAndWholeExtents) {
  EXPECT_THAT(report("terrain: {raster: ''}"), HasSubstr("terrain.raster: an empty name"));
  EXPECT_THAT(report("terrain: {raster: a, crs: ''}"), HasSubstr("terrain.crs: an empty name"));
  EXPECT_THAT(report("terrain: {raster: [a]}"), HasSubstr("terrain.raster"));
  EXPECT_THAT(report("terrain: {raster: a, west: 1, south: 2, east: 3}"),
              HasSubstr("terrain.north: missing"));
  EXPECT_THAT(report("terrain: {raster: a, west: 5, south: 2, east: 3, north: 4}"),
              HasSubstr("east must be greater than west"));
}

TEST(WorldReader, MorePartsThanCanBeWorkedThroughAreRefused) {
  std::string peaks, mapped;
  for (int i = 0; i < 1001; ++i) {
    peaks += "{at: [0, 0], risk: 1, radius: 5}, ";
    mapped += "[[0, 0], [1, 0], [1, 1]], ";
  }

  EXPECT_THAT(report(kRaster + "ground: {risk: {peaks: [" + peaks + "]}}"),
              HasSubstr("ground.risk.peaks: 1001 of them; expected at most 1000"));
  EXPECT_THAT(report(kRaster + "ground: {mapped: [" + mapped + "]}"),
              HasSubstr("ground.mapped: 1001 of them"));
}

TEST(WorldReader, WhatIsNoWorldIsSaidToBeNone) {
  EXPECT_THAT(report(""), HasSubstr("the file is empty"));
  EXPECT_THAT(report("[1, 2]"), HasSubstr("this is not a world"));
  EXPECT_THAT(report("terrain: {"), HasSubstr("w.yaml:1"));
  EXPECT_THAT(report("origin: 5"), HasSubstr("terrain: missing"));
  EXPECT_THAT(report("terrain: 5"), HasSubstr("where a map was expected"));
}

}  // namespace
}  // namespace skein::world
