// SPDX-License-Identifier: Apache-2.0
// The world of a scenario: measured ground, and worlds that several scenarios include.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/files.hpp"

namespace skein::scenario {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::scenario_with;
using testing::TemporaryFolder;
using world::Vector3;

const std::string kHills =
    "  origin: {latitude: 40.1, longitude: -8.2, altitude: 200}\n"
    "  terrain: {west: -500, south: -500, east: 500, north: 500, cell: 20, base: 10}\n";
const std::string kGrid = "  terrain: {grid: ground.terrain}\n";

/// 3 × 3 corners from -500 to 500: level in the south, 100 m high in the north.
constexpr const char* kMeasured =
    "skein_terrain: 1\nsource: made up\norigin: {latitude: 47, longitude: 11, altitude: 900}\n"
    "west: -500\nsouth: -500\neast: 500\nnorth: 500\ncell: 500\n"
    "---\n100 100 100\n50 50 50\n0 0 0\n";

/// Models are found where the COMETS scenarios have them.
std::string with_models(std::string text) {
  for (const std::string model : {"marvin", "heliv"}) {
    const std::string name = "models/" + model + ".yaml";
    text.replace(text.find(name), name.size(), SKEIN_SOURCE_DIR "/scenarios/comets/" + name);
  }
  return text;
}

struct Read {
  std::optional<Scenario> scenario;
  std::string errors;
};

Read read_in(const TemporaryFolder& folder, const std::string& text) {
  auto scenario = read_scenario(folder.write("s/small.yaml", with_models(text)));
  if (scenario) return {std::move(*scenario), ""};
  std::string errors = to_text(scenario.error());
  const std::string prefix = folder.path("s/");
  for (auto at = errors.find(prefix); at != std::string::npos; at = errors.find(prefix))
    errors.erase(at, prefix.size());
  return {std::nullopt, errors};
}

TEST(MeasuredGround, IsNamedByAFileBesideTheScenarioAndKnowsItsOrigin) {
  const TemporaryFolder folder;
  folder.write("s/ground.terrain", kMeasured);
  const Read read = read_in(folder, scenario_with(kHills, kGrid));
  ASSERT_TRUE(read.scenario) << read.errors;

  EXPECT_EQ(read.scenario->world.origin, (world::GeodeticOrigin{47, 11, 900}));
  const world::Terrain terrain(read.scenario->world.terrain);
  EXPECT_EQ(terrain.elevation(0, 0), 50);
  EXPECT_EQ(terrain.elevation(0, 250), 75);
}

TEST(MeasuredGround, MayHaveHillsOnIt) {
  const TemporaryFolder folder;
  folder.write("s/ground.terrain", kMeasured);
  const Read read =
      read_in(folder, scenario_with(kHills,
                                    "  terrain:\n    grid: ground.terrain\n"
                                    "    hills: [{at: [0, 0], height: 20, radius: 100}]\n"));
  ASSERT_TRUE(read.scenario) << read.errors;

  EXPECT_EQ(world::Terrain(read.scenario->world.terrain).elevation(0, 0), 70);
}

TEST(MeasuredGround, AnAntennaBelowItIsAnError) {
  const TemporaryFolder folder;
  folder.write("s/ground.terrain", kMeasured);
  std::string text = scenario_with(kHills, kGrid);
  text.replace(text.find("ground:\n"), 8, "ground:\n  position: [0, 250, 8]\n");

  EXPECT_THAT(read_in(folder, text).errors,
              HasSubstr("ground.position: the antenna is 67.0 m below the ground; expected a "
                        "height over 75.0 m there"));
}

TEST(MeasuredGround, TwoErrorsInTheTerrainFileAreBothTold) {
  const TemporaryFolder folder;
  std::string text = kMeasured;
  text.replace(text.find("50 50 50"), 8, "50 50 up");
  folder.write("s/ground.terrain", text + "0 0 0\n");

  EXPECT_EQ(read_in(folder, scenario_with(kHills, kGrid)).errors,
            "ground.terrain:11: 'up'; expected an elevation in metres\n"
            "ground.terrain:11: 2 elevations in a row; expected 3\n"
            "ground.terrain: 4 rows of elevations; expected 3\n");
}

TEST(MeasuredGround, AMissingFileAndAnOriginBesideItAreErrors) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_in(folder, scenario_with(kHills, kGrid)).errors,
            "small.yaml:5:19: world.terrain.grid: terrain file 'ground.terrain' cannot be read\n");
  folder.write("s/ground.terrain", kMeasured);
  const std::string twice = "  origin: {latitude: 40, longitude: -8, altitude: 0}\n" + kGrid;
  EXPECT_THAT(read_in(folder, scenario_with(kHills, twice)).errors,
              HasSubstr("world.origin: the terrain file says it"));
}

TEST(Places, OfTwoCoordinatesLieOnTheGround) {
  const TemporaryFolder folder;
  folder.write("s/ground.terrain", kMeasured);
  std::string text = scenario_with(kHills, kGrid);
  text.replace(text.find("aside: [50, 60, 70]"), 19, "aside: [50, 250]   ");
  const Read read = read_in(folder, text);
  ASSERT_TRUE(read.scenario) << read.errors;

  EXPECT_EQ(read.scenario->world.places.at("aside"), Vector3(50, 250, 75));
  EXPECT_EQ(read.scenario->world.places.at("base"), Vector3(0, 0, 0));
}

constexpr const char* kIncluded =
    "origin: {latitude: 40.1, longitude: -8.2, altitude: 200}\n"
    "terrain: {west: -500, south: -500, east: 500, north: 500, cell: 20}\n"
    "wind: {toward: 1, speed: 3, gusts: 0}\n"
    "places: {camp: [-100, 0, 0]}\n";

TEST(IncludedWorld, IsTheWorldOfEveryScenarioThatNamesIt) {
  const TemporaryFolder folder;
  folder.write("worlds/plain.yaml", kIncluded);
  const Read read = read_in(folder, scenario_with(kHills, "  include: ../worlds/plain.yaml\n"));
  ASSERT_TRUE(read.scenario) << read.errors;

  const WorldSpec& world = read.scenario->world;
  EXPECT_EQ(world.origin.latitude_degrees, 40.1);
  EXPECT_EQ(world.terrain.east, 500);
  EXPECT_EQ(world.wind.speed, 3);
  EXPECT_EQ(world.zones.size(), 1u) << "its own";
  EXPECT_EQ(world.places.size(), 3u) << "of both";
  EXPECT_EQ(world.places.at("camp"), Vector3(-100, 0, 0));
}

TEST(IncludedWorld, WhatTheScenarioSaysItselfCountsBeforeIt) {
  const TemporaryFolder folder;
  folder.write("worlds/plain.yaml", kIncluded);
  const Read read = read_in(folder, scenario_with(kHills,
                                                  "  include: ../worlds/plain.yaml\n"
                                                  "  wind: {toward: 0, speed: 7, gusts: 0}\n"));
  ASSERT_TRUE(read.scenario) << read.errors;

  EXPECT_EQ(read.scenario->world.wind.speed, 7);
}

TEST(IncludedWorld, ANameInBothIsAnError) {
  const TemporaryFolder folder;
  folder.write("worlds/plain.yaml",
               std::string(kIncluded) + "zones: {Z: [[0, 0], [1, 0], [1, 1]]}\n");

  EXPECT_THAT(read_in(folder, scenario_with(kHills, "  include: ../worlds/plain.yaml\n")).errors,
              HasSubstr("world.zones.Z: 'Z' is in " + folder.path("worlds/plain.yaml") + " too"));
}

TEST(IncludedWorld, ItsTerrainFileIsBesideIt) {
  const TemporaryFolder folder;
  folder.write("worlds/fell.yaml", "terrain: {grid: ground.terrain}\n");
  folder.write("worlds/ground.terrain", kMeasured);
  const Read read = read_in(folder, scenario_with(kHills, "  include: ../worlds/fell.yaml\n"));
  ASSERT_TRUE(read.scenario) << read.errors;

  EXPECT_EQ(read.scenario->world.origin.altitude, 900);
}

TEST(IncludedWorld, ErrorsInItAreToldWithItsNameAndLine) {
  const TemporaryFolder folder;
  folder.write("worlds/plain.yaml",
               "origin: {latitude: 400, longitude: 0, altitude: 0}\n"
               "terain: {}\n");
  const std::string errors =
      read_in(folder, scenario_with(kHills, "  include: ../worlds/plain.yaml\n")).errors;

  EXPECT_THAT(errors, HasSubstr("worlds/plain.yaml:1:20: origin.latitude: '400'"));
  EXPECT_THAT(errors, HasSubstr("worlds/plain.yaml:2:9: terain: unknown key 'terain'"));
  EXPECT_THAT(errors, HasSubstr("world.terrain: missing"));
}

TEST(IncludedWorld, CannotBeReadIsToldOnceAndIncludesNothingItself) {
  const TemporaryFolder folder;
  const std::string text = scenario_with(kHills, "  include: nowhere.yaml\n");
  EXPECT_THAT(read_in(folder, text).errors,
              HasSubstr("small.yaml:5:12: world.include: world 'nowhere.yaml' cannot be read"));
  folder.write("s/nowhere.yaml", "include: nowhere.yaml\n");
  EXPECT_THAT(read_in(folder, text).errors, HasSubstr("include: unknown key 'include'"));
}

/// Marvin with a device of a name that nobody knows, whose model says `more` of it.
Read with_device(const TemporaryFolder& folder, const std::string& more) {
  folder.write("s/probe.yaml",
               "model: probe\nkind: helicopter\nhovers: true\nspeed: {cruise: 8, max: 14}\n"
               "climb_rate: 3\ndescent_rate: 2\nacceleration: 2\nyaw_rate: 0.8\nceiling: 300\n"
               "position_precision: 0.3\nwind_drift: 0.05\n"
               "energy: {capacity: 6.5e6, ground: 100, hover: 1700, cruise: 1500, climb: 400, "
               "reserve: 0.08}\n"
               "sensors:\n  nose: {aperture: 0.5, pitch: -1.5, range: 100, period: 1, "
               "position_spread: 3, sees: {fire: {probability: 0.9, confidence: 0.8}}" +
                   more + "}\n");
  std::string text = scenario_with("device: visible", "device: nose");
  text.replace(text.find("marvin: {model: models/marvin.yaml"), 34, "marvin: {model: probe.yaml");
  text.insert(text.find("expect:"), "# models/marvin.yaml\n");
  return read_in(folder, text);
}

TEST(Devices, OfNamesThatNobodyKnowsSayWhatTheirLooksAreWorth) {
  const TemporaryFolder folder;
  const Read read = with_device(folder, ", evidence: {reports: {fire: [0.7, 0.1]}, limit: 3}");
  ASSERT_TRUE(read.scenario) << read.errors;

  const auto& models = read.scenario->ground.pps.models;
  ASSERT_EQ(models.count({"marvin", "nose"}), 1u);
  EXPECT_EQ(models.at({"marvin", "nose"}).limit, 3);
}

TEST(Devices, OfWhichNobodySaysItAreAnErrorAndNeverSilence) {
  const TemporaryFolder folder;

  EXPECT_THAT(with_device(folder, "").errors,
              HasSubstr("uavs.marvin.model: what the looks of 'nose' are worth is not said"));
}

}  // namespace
}  // namespace skein::scenario
