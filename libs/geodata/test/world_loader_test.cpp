// SPDX-License-Identifier: Apache-2.0
#include "skein/geodata/world_loader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raster_files.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/world/polygon_check.hpp"

namespace skein::geodata {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using world::World;

const std::string kTerrain = SKEIN_SOURCE_DIR "/scenarios/terrain/";

World read(const std::string& path) {
  auto world = read_world(path);
  if (!world) ADD_FAILURE() << to_text(world.error());
  return std::move(world.value());
}

std::string report(const std::string& path) {
  const auto world = read_world(path);
  return world ? "" : to_text(world.error());
}

TEST(WorldLoader, TheValleyIsAWorldForEveryService) {
  const World valley = read(kTerrain + "valley.yaml");

  EXPECT_GT(valley.terrain.highest(), 200);
  EXPECT_EQ(valley.volumes.size(), 2u);
  EXPECT_EQ(valley.zones.size(), 3u);
  EXPECT_EQ(valley.airspace.size, (std::array<std::int32_t, 3>{200, 200, 34}));
  EXPECT_GT(valley.ground.risk_at({620, 520}), 0.9);
  for (const auto& [name, place] : valley.places)
    EXPECT_GE(place.z(), valley.terrain.elevation(place.x(), place.y())) << name;
}

TEST(WorldLoader, JacksboroIsRealGround) {
  const World world = read(kTerrain + "jacksboro.yaml");

  EXPECT_EQ(world.origin, (world::GeodeticOrigin{36.5895, -84.246, 300}));
  EXPECT_GT(world.terrain.highest() - world.terrain.lowest(), 600);
  ASSERT_EQ(world.volumes.size(), 2u);
  EXPECT_EQ(world.volumes[1].when.from, MissionTime::seconds(900));
  EXPECT_TRUE(world.radio.budget);
  const world::Vector3 lookout =
      geodesy::GeodeticFrame(world.origin).to_local({36.601, -84.268, 900});
  EXPECT_EQ(world.places.at("lookout"), lookout);
  EXPECT_TRUE(world::problems_of(world.airspace).empty());
  for (const auto& [name, place] : world.places)
    EXPECT_GE(place.z(), world.terrain.elevation(place.x(), place.y())) << name;
}

TEST(WorldLoader, RastersAreFoundFromTheFolderOfTheFile) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.path("data"));
  TiffSpec risk;
  risk.value = [](int, int) { return 0.25; };
  write_tiff(folder, "data/dem.tif", {});
  write_tiff(folder, "data/risk.tif", risk);
  const std::string path = folder.write("w.yaml", R"(terrain: {raster: data/dem.tif}
ground: {cell: 50, risk: {raster: data/risk.tif}}
)");

  const World world = read(path);

  EXPECT_NEAR(world.origin.altitude, 100, 1e-4);
  EXPECT_NEAR(world.terrain.elevation(0, 0), 0, 1e-3);
  EXPECT_EQ(world.ground.risk_at({0, 0}), 0.25);
  EXPECT_EQ(world.ground.risk.size(), world.ground.grid.size());
}

TEST(WorldLoader, ARasterThatCannotBeReadIsSaidOfTheLineThatNamesIt) {
  const TempFolder folder;
  const std::string path = folder.write("w.yaml", R"(wind: {speed: 1}
terrain:
  raster: none.tif
)");

  EXPECT_THAT(report(path), StartsWith(path + ":3: terrain.raster: " + folder.path("none.tif") +
                                       ": there is no such file"));
}

TEST(WorldLoader, ARiskRasterThatCannotBeReadToo) {
  const TempFolder folder;
  const std::string path =
      folder.write("w.yaml", R"(origin: {latitude: 37, longitude: -6, altitude: 0}
terrain: {west: -100, south: -100, east: 100, north: 100}
ground: {risk: {raster: none.tif}}
)");

  EXPECT_THAT(report(path), HasSubstr("w.yaml:3: ground.risk.raster: "));
}

TEST(WorldLoader, EveryErrorOfTheTextIsGivenAtOnce) {
  const TempFolder folder;
  const std::string path = folder.write("w.yaml", "terrain: {raster: a.tif, cel: 1}\nwinds: 1\n");

  const auto world = read_world(path);

  ASSERT_FALSE(world);
  EXPECT_EQ(world.error().size(), 2u) << to_text(world.error());
}

TEST(WorldLoader, AWorldFileThatIsNoneIsRefused) {
  const TempFolder folder;

  EXPECT_THAT(report(folder.path("none.yaml")), HasSubstr("cannot be read"));
  EXPECT_THAT(report(folder.path("")), HasSubstr("cannot be read"));
  EXPECT_NE(report(folder.write("empty.yaml", "")), "");
}

TEST(WorldLoader, WhatDoesNotFitTheGroundIsRefusedAfterIt) {
  const TempFolder folder;
  write_tiff(folder, "dem.tif", {});
  const std::string path = folder.write("w.yaml", R"(terrain: {raster: dem.tif}
airspace: {ceiling: -500}
ground: {fires: [[90000, 0]]}
)");

  EXPECT_THAT(report(path), HasSubstr("w.yaml:2: airspace: the airspace has no extent"));
  EXPECT_THAT(report(path), HasSubstr("w.yaml:3: ground: "));
}

}  // namespace
}  // namespace skein::geodata
