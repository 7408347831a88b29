// SPDX-License-Identifier: Apache-2.0
// What GDAL's drivers, which know nothing of Skein, read back of our files.
#include "skein/track_files/tracks.hpp"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <fstream>
#include <memory>
#include <random>

#include "skein/mission_files/read.hpp"
#include "temporary_folder.hpp"

namespace skein::track_files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

struct Point {
  double x, y, z;
};

class Tracks : public ::testing::Test {
 protected:
  Tracks() {
    GDALAllRegister();
    CPLSetConfigOption("GPX_ELE_AS_25D", "YES");
    info_.scenario = "search & rescue";
    info_.epoch = "2005-05-19T09:00:00Z";
    info_.version = "0.1";
    info_.origin = report::Origin{40.1094, -8.2361, 200};
    info_.uavs = {{"marvin", "comets/marvin", 3}, {"karma", "<blimp>", 3}};
    info_.places = {{"pad", {100, -50, 20}}};
    info_.zones = {{"field", {{0, 0}, {200, 0}, {200, 100}}}};
    info_.air = {{"tower", {{300, 0}, {320, 0}, {320, 30}, {300, 30}}, 0, {}}};
  }

  void fly(const std::string& uav, double at, const Point& to) {
    records_.push_back(journal::Record(MissionTime::seconds(at), "sim", "telemetry")
                           .with("uav", uav)
                           .with("position", std::vector<double>{to.x, to.y, to.z}));
  }
  void raise(int id, double at, const std::string& state, double x) {
    records_.push_back(journal::Record(MissionTime::seconds(at), "ground", "alarm")
                           .with("alarm", id)
                           .with("state", state)
                           .with("position", std::vector<double>{x, 0, 0}));
  }
  /// Two minutes of both, at random.
  std::vector<Point> fly_anywhere() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> far(-3000, 3000), high(0, 300);
    std::vector<Point> all;
    for (int i = 0; i < 120; ++i) {
      all.push_back({far(random), far(random), high(random)});
      fly("marvin", i, all.back());
      fly("karma", i, {static_cast<double>(i), 0, 10});
    }
    return all;
  }
  using Dataset = std::unique_ptr<GDALDataset>;
  Dataset open(const std::string& text, const std::string& name, const char* driver) const {
    const std::string file = (folder_.path() / name).string();
    std::ofstream(file) << text;
    const char* const drivers[] = {driver, nullptr};
    return Dataset(static_cast<GDALDataset*>(
        GDALOpenEx(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr)));
  }
  /// Distances are those of the flight, by the ellipsoid's axes in space (PROJ).
  static void expect_as_flown(const OGRLineString& line, const std::vector<Point>& flown) {
    ASSERT_EQ(static_cast<std::size_t>(line.getNumPoints()), flown.size());
    OGRSpatialReference degrees, space;
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    degrees.importFromEPSG(4979);
    space.importFromEPSG(4978);
    const std::unique_ptr<OGRCoordinateTransformation> to_space(
        OGRCreateCoordinateTransformation(&degrees, &space));
    ASSERT_TRUE(to_space);
    const auto in_space = [&](double x, double y, double z) {
      EXPECT_TRUE(to_space->Transform(1, &x, &y, &z));
      return Point{x, y, z};
    };
    const Point origin = in_space(-8.2361, 40.1094, 200);
    for (int i = 0; i < line.getNumPoints(); ++i) {
      const Point there = in_space(line.getX(i), line.getY(i), line.getZ(i));
      const Point& meant = flown[static_cast<std::size_t>(i)];
      EXPECT_NEAR(std::hypot(there.x - origin.x, there.y - origin.y, there.z - origin.z),
                  std::hypot(meant.x, meant.y, meant.z), 2e-3)
          << "fix " << i;
    }
  }

  skein::testing::TemporaryFolder folder_;
  report::RunInfo info_;
  std::vector<journal::Record> records_;
};

TEST_F(Tracks, GdalReadsEveryFixOfTheGpxWithItsInstant) {
  const auto flown = fly_anywhere();

  const Dataset dataset = open(to_gpx(info_, records_), "run.gpx", "GPX");

  ASSERT_TRUE(dataset);
  OGRLayer* tracks = dataset->GetLayerByName("tracks");
  ASSERT_NE(tracks, nullptr);
  ASSERT_EQ(tracks->GetFeatureCount(), 2);
  const OGRFeatureUniquePtr first(tracks->GetNextFeature());
  EXPECT_STREQ(first->GetFieldAsString("name"), "marvin");
  expect_as_flown(*first->GetGeometryRef()->toMultiLineString()->getGeometryRef(0), flown);
  OGRLayer* points = dataset->GetLayerByName("track_points");
  ASSERT_NE(points, nullptr);
  EXPECT_EQ(points->GetFeatureCount(), 240);
  const OGRFeatureUniquePtr tenth(points->GetFeature(9));
  EXPECT_STREQ(tenth->GetFieldAsString("time"), "2005/05/19 09:00:09+00");
}

TEST_F(Tracks, GdalReadsEveryFixOfTheKml) {
  const auto flown = fly_anywhere();

  const Dataset dataset = open(to_kml(info_, records_), "run.kml", "KML");

  ASSERT_TRUE(dataset);
  OGRLayer* layer = dataset->GetLayerByName("marvin");
  ASSERT_NE(layer, nullptr);
  const OGRFeatureUniquePtr track(layer->GetNextFeature());
  EXPECT_STREQ(track->GetFieldAsString("Name"), "marvin");
  expect_as_flown(*track->GetGeometryRef()->toLineString(), flown);
}

TEST_F(Tracks, TheTrackInTimeHasAnInstantForEachFix) {
  fly_anywhere();

  const std::string kml = to_kml(info_, records_);
  const Dataset dataset = open(kml, "run.kml", "LIBKML");

  std::size_t instants = 0;
  for (std::size_t at = 0; (at = kml.find("<when>", at)) != std::string::npos; ++at) ++instants;
  EXPECT_EQ(instants, 240U);
  EXPECT_THAT(kml, HasSubstr("<when>2005-05-19T09:01:59Z</when>"));
  if (!dataset) GTEST_SKIP() << "GDAL without libkml";
  OGRLayer* layer = dataset->GetLayerByName("marvin");
  ASSERT_NE(layer, nullptr);
  EXPECT_EQ(layer->GetFeatureCount(), 2);
}

TEST_F(Tracks, HeightsCountFromTheSeaWhenItsHeightIsGiven) {
  fly("marvin", 0, {0, 0, 30});
  fly("marvin", 1, {0, 0, 30});

  const Dataset dataset = open(to_gpx(info_, records_, {54.5}), "run.gpx", "GPX");

  ASSERT_TRUE(dataset);
  const OGRFeatureUniquePtr point(dataset->GetLayerByName("track_points")->GetNextFeature());
  EXPECT_NEAR(point->GetFieldAsDouble("ele"), 200 + 30 - 54.5, 1e-3);
}

TEST_F(Tracks, AlarmsAreTheirLastStateAndPlacesAreWayPoints) {
  raise(1, 1, "raised", 10);
  raise(11, 2, "raised", 30);
  raise(1, 3, "confirmed", 12);

  const Dataset dataset = open(to_gpx(info_, records_), "run.gpx", "GPX");

  ASSERT_TRUE(dataset);
  std::vector<std::string> names;
  for (const auto& feature : *dataset->GetLayerByName("waypoints"))
    names.emplace_back(feature->GetFieldAsString("name"));
  EXPECT_THAT(names, ElementsAre("pad", "alarm 1 confirmed", "alarm 11 raised"));
}

TEST_F(Tracks, WhatWasDrawnCanBeImportedAgain) {
  fly_anywhere();

  const auto read = mission_files::read_text(to_kml(info_, records_), "run.kml");

  ASSERT_TRUE(read) << to_text(read.error());
  ASSERT_THAT(read->areas, SizeIs(2));
  EXPECT_EQ(read->areas[0].name, "field");
  EXPECT_THAT(read->areas[1].folders, ElementsAre("search & rescue", "closed air"));
  EXPECT_THAT(read->ways, SizeIs(2));
}

TEST_F(Tracks, NamesThatLookLikeMarkupAreText) {
  info_.uavs = {{"</kml>&", "]]>", 3}};
  fly("</kml>&", 0, {0, 0, 1});
  fly("</kml>&", 1, {0, 1, 1});

  const Dataset kml = open(to_kml(info_, records_), "run.kml", "KML");
  const Dataset gpx = open(to_gpx(info_, records_), "run.gpx", "GPX");

  ASSERT_TRUE(kml);
  EXPECT_NE(kml->GetLayerByName("</kml>&"), nullptr);
  ASSERT_TRUE(gpx);
  EXPECT_EQ(gpx->GetLayerByName("tracks")->GetFeatureCount(), 1);
}

TEST_F(Tracks, APositionFarFromEarthIsWrittenInWhole) {
  fly("marvin", 0, {0, 0, 1e300});
  fly("marvin", 1, {0, 0, -1e308});

  for (const std::string& file : {to_kml(info_, records_), to_gpx(info_, records_)})
    EXPECT_EQ(file.find('\0'), std::string::npos);
}

TEST_F(Tracks, ARunInWhichNobodyWasSeenIsAFileWithoutTracks) {
  const Dataset dataset = open(to_gpx(info_, {}), "run.gpx", "GPX");

  ASSERT_TRUE(dataset);
  EXPECT_EQ(dataset->GetLayerByName("tracks")->GetFeatureCount(), 0);
}

}  // namespace
}  // namespace skein::track_files
