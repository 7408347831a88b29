// SPDX-License-Identifier: Apache-2.0
// `skein import` from its options to its file.
#include "skein/import_tool/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/scenario/scenario.hpp"
#include "temporary_folder.hpp"

namespace skein::import_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

const std::string kScenarios = std::string(SKEIN_SOURCE_DIR) + "/scenarios";

const char* const kKml = R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document>
<Placemark><name>Field</name><Polygon><outerBoundaryIs><LinearRing><coordinates>
-8.2361,40.1094 -8.2340,40.1094 -8.2340,40.1110</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>
<Placemark><name>pad</name><Point><coordinates>-8.2361,40.1094</coordinates></Point></Placemark>
<Placemark><name>lap</name><LineString><coordinates>-8.2350,40.1100 -8.2345,40.1105</coordinates></LineString></Placemark>
</Document></kml>)";

class Import : public ::testing::Test {
 protected:
  Import() {
    options_.out = path("s.yaml");
    options_.model = kScenarios + "/comets/models/marvin.yaml";
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  void keep(const std::string& name, const std::string& text) {
    options_.file = path(name);
    std::ofstream(options_.file) << text;
  }
  int run() { return import_mission(options_, out_, err_); }
  std::string text() const {
    std::ifstream in(options_.out);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  scenario::Scenario made() const {
    auto read = scenario::read_scenario(options_.out);
    EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
    return read ? std::move(*read) : scenario::Scenario();
  }

  skein::testing::TemporaryFolder folder_;
  ImportOptions options_;
  std::ostringstream out_, err_;
};

TEST_F(Import, AMapBecomesAScenarioThatIsAccepted) {
  keep("a map.kml", kKml);

  ASSERT_EQ(run(), kExitOk) << err_.str();

  const scenario::Scenario scenario = made();
  EXPECT_EQ(scenario.name, "a-map");
  ASSERT_THAT(scenario.world.zones, SizeIs(1));
  EXPECT_EQ(scenario.world.zones[0].name, "Field");
  EXPECT_EQ(scenario.world.places.count("pad"), 1U);
  ASSERT_THAT(scenario.uavs, SizeIs(1));
  EXPECT_EQ(scenario.uavs[0].name, "uav");
  EXPECT_THAT(text(), HasSubstr("type: takeoff, params: {altitude: 40}"));
  EXPECT_THAT(err_.str(), HasSubstr("the file says no home"));
}

TEST_F(Import, IntoAWorldItsFrameGroundAndNamesCount) {
  keep("a.kml", kKml);
  std::ofstream(path("w.yaml"))
      << "origin: {latitude: 40.1094, longitude: -8.2361, altitude: 200}\n"
         "terrain: {west: -500, south: -500, east: 500, north: 500, base: 12}\n"
         "zones: {Field: [[0, 0], [10, 0], [10, 10]]}\n";
  options_.world = path("w.yaml");
  options_.home = {40.1094, -8.2361};

  ASSERT_EQ(run(), kExitOk) << err_.str();

  const scenario::Scenario scenario = made();
  EXPECT_THAT(text(), HasSubstr("include: \"w.yaml\""));
  ASSERT_THAT(scenario.world.zones, SizeIs(2));
  EXPECT_EQ(scenario.world.zones[0].name, "Field-2");
  EXPECT_NEAR(scenario.uavs[0].start.norm(), 0, 0.01);
  EXPECT_NEAR(scenario.world.places.at("pad").z(), 12, 0.01);
}

TEST_F(Import, HomeOutsideOfTheWorldIsRefused) {
  keep("a.kml", kKml);
  options_.world = kScenarios + "/worlds/lousa.yaml";
  options_.home = {41, -8};

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("home is at x "));
  EXPECT_THAT(err_.str(), HasSubstr("outside of the world's ground"));
}

TEST_F(Import, WhatHasNoCounterpartIsRefusedUnlessItIsToBeLeftOut) {
  keep("m.waypoints",
       "QGC WPL 110\n0 1 0 16 0 0 0 0 47.5 8.25 430 1\n1 0 3 22 0 0 0 0 0 0 20 1\n"
       "2 0 3 177 1 2 0 0 0 0 0 1\n3 0 3 20 0 0 0 0 0 0 0 1\n");

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("m.waypoints:4: DO_JUMP (177)\n"));
  EXPECT_THAT(err_.str(), HasSubstr("--leave-out imports the rest"));
  EXPECT_FALSE(std::filesystem::exists(options_.out));

  options_.leave_out = true;
  EXPECT_EQ(run(), kExitOk) << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("left out: "));
  EXPECT_THAT(text(), HasSubstr("#   " + options_.file + ":4: DO_JUMP (177)"));
}

TEST_F(Import, EveryErrorOfTheFileIsTold) {
  keep("m.waypoints", "QGC WPL 110\n0 1 3 16 0 0 0 0 97 8.25 430 1\n1 0 3 22 0\n");

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("m.waypoints:2: latitude 97"));
  EXPECT_THAT(err_.str(), HasSubstr("m.waypoints:3: 5 columns"));
}

TEST_F(Import, WhatIsWrongWithAllPointsOfAWayIsToldOnce) {
  std::string text = kKml;
  text.replace(text.find("<LineString>"), 12, "<LineString><altitudeMode>absolute</altitudeMode>");
  keep("a.kml", text);

  EXPECT_EQ(run(), kExitBadInput);
  const std::string told = err_.str();
  EXPECT_THAT(told, HasSubstr("its height counts from sea level; expected --geoid METRES"));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
}

TEST_F(Import, ErrorsOfTheModelAreTheModels) {
  keep("a.kml", kKml);
  options_.model = path("none.yaml");

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("none.yaml' cannot be read"));
}

TEST_F(Import, APlanThatOnlyHasFencesIsAScenarioInWhichNothingFlies) {
  keep("f.plan", R"({"fileType": "Plan", "version": 1, "mission": {"items": [],
    "plannedHomePosition": [47.5, 8.25, 430]}, "geoFence": {"version": 2, "polygons": [
    {"inclusion": true, "polygon": [[47.49, 8.24], [47.49, 8.26], [47.51, 8.26], [47.51, 8.24]]}]}})");

  ASSERT_EQ(run(), kExitOk) << err_.str();

  const scenario::Scenario scenario = made();
  EXPECT_THAT(scenario.world.volumes, SizeIs(2));
  EXPECT_EQ(scenario.ground.script.steps.size(), 1U);
  EXPECT_NEAR(scenario.world.origin.latitude_degrees, 47.5, 1e-8);
  EXPECT_NEAR(scenario.world.origin.altitude, 430, 1e-6);
}

TEST_F(Import, NamesOfOthersCannotBreakTheScenario) {
  std::string text = kKml;
  const std::string name = "<name>Field</name>";
  text.replace(text.find(name), name.size(), "<name>\"]}\n- # evil: *x &amp;y</name>");
  keep("e.kml", text);

  ASSERT_EQ(run(), kExitOk) << err_.str();
  EXPECT_EQ(made().world.zones.at(0).name, "evil-x-y");
}

TEST_F(Import, PointsAHundredKilometresApartAreRefused) {
  keep("far.waypoints",
       "QGC WPL 110\n0 1 0 16 0 0 0 0 47.5 8.25 430 1\n"
       "1 0 3 16 0 0 0 0 49.5 8.25 20 1\n");

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("km apart"));
}

TEST_F(Import, WithoutAFileToWriteTheScenarioIsSaid) {
  keep("a.kml", kKml);
  options_.out.clear();

  ASSERT_EQ(run(), kExitOk);
  EXPECT_THAT(out_.str(), HasSubstr("scenario: \"a\""));
}

TEST_F(Import, SaysWhatItCannotWrite) {
  keep("a.kml", kKml);
  options_.out = path("a-folder");
  std::filesystem::create_directory(options_.out);

  EXPECT_EQ(run(), kExitSystem);
  EXPECT_THAT(err_.str(), HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace skein::import_tool
