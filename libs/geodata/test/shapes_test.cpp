// SPDX-License-Identifier: Apache-2.0
#include "skein/geodata/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "skein/geodesy/geodetic_frame.hpp"

namespace skein::geodata {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using world::Vector3;

constexpr world::GeodeticOrigin kOrigin{40, -8, 100};

class Shapes : public ::testing::Test {
 protected:
  Shapes() { std::filesystem::create_directories(folder_); }
  ~Shapes() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  static std::string errors_of(const Result<std::vector<Shape>, Diagnostics>& shapes) {
    return shapes ? "" : to_text(shapes.error());
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("skein-shapes-" + std::to_string(::getpid()));
};

constexpr const char* kTwoFields = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "north"}, "geometry": {"type": "Polygon",
   "coordinates": [[[-8, 40], [-7.998, 40], [-7.998, 40.001], [-8, 40.001], [-8, 40]],
                   [[-7.9995, 40.0002], [-7.999, 40.0002], [-7.999, 40.0005], [-7.9995, 40.0002]]]}},
  {"type": "Feature", "properties": {"name": "road"}, "geometry": {"type": "LineString",
   "coordinates": [[-8, 40], [-7.9, 40]]}},
  {"type": "Feature", "properties": {"name": "south"}, "geometry": {"type": "MultiPolygon",
   "coordinates": [[[[-8, 39.9], [-7.9, 39.9], [-7.9, 39.95], [-8, 39.9]]],
                   [[[-8, 39.8], [-7.9, 39.8], [-7.9, 39.85], [-8, 39.8]]]]}}]})";

TEST_F(Shapes, PolygonsOfGeoJsonAreReadWithTheirNamesAndHoles) {
  const auto shapes = read_shapes(write("fields.geojson", kTwoFields), kOrigin);

  ASSERT_TRUE(shapes) << errors_of(shapes);
  ASSERT_THAT(*shapes, SizeIs(3));
  EXPECT_EQ((*shapes)[0].name, "north");
  EXPECT_THAT((*shapes)[0].outer, SizeIs(4));
  ASSERT_THAT((*shapes)[0].holes, SizeIs(1));
  EXPECT_THAT((*shapes)[0].holes[0], SizeIs(3));
  EXPECT_EQ((*shapes)[1].name, "south");
  EXPECT_EQ((*shapes)[2].name, "south");
  // A degree of latitude is 111,034 m there, one of longitude 85,394 m.
  EXPECT_NEAR((*shapes)[0].outer[2].x(), 2 * 85.394, 0.1);
  EXPECT_NEAR((*shapes)[0].outer[2].y(), 111.034, 0.1);
}

TEST_F(Shapes, PolygonsOfKmlAreRead) {
  const auto shapes = read_shapes(write("field.kml", R"(<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><name>meadow</name><Polygon>
<outerBoundaryIs><LinearRing><coordinates>-8,40,0 -7.998,40,0 -7.998,40.001,0 -8,40,0</coordinates>
</LinearRing></outerBoundaryIs></Polygon></Placemark></Document></kml>)"),
                                  kOrigin);

  ASSERT_TRUE(shapes) << errors_of(shapes);
  ASSERT_THAT(*shapes, SizeIs(1));
  EXPECT_EQ((*shapes)[0].name, "meadow");
  EXPECT_THAT((*shapes)[0].outer, SizeIs(3));
  EXPECT_NEAR((*shapes)[0].outer[1].x(), 2 * 85.394, 0.1);
}

TEST_F(Shapes, WktIsInMetresUnlessItIsSaidInWhat) {
  const auto local =
      read_shapes(write("a.wkt", "POLYGON ((0 0, 200 0, 200 100, 0 0))\n\n"), kOrigin);
  const auto degrees = read_shapes(
      write("b.wkt", "POLYGON ((-8 40, -7.998 40, -7.998 40.001, -8 40))"), kOrigin, "EPSG:4326");
  const auto utm = read_shapes(
      write("c.wkt", "POLYGON ((585360 4428236, 585560 4428236, 585560 4428336, 585360 4428236))"),
      kOrigin, "EPSG:32629");

  ASSERT_TRUE(local && degrees && utm) << errors_of(utm);
  EXPECT_EQ((*local)[0].outer, (world::Polygon{{0, 0}, {200, 0}, {200, 100}}));
  EXPECT_NEAR((*degrees)[0].outer[1].x(), 2 * 85.394, 0.1);
  EXPECT_NEAR(((*utm)[0].outer[1] - (*utm)[0].outer[0]).norm(), 200, 0.2);
  EXPECT_LT((*utm)[0].outer[0].norm(), 100);
}

TEST_F(Shapes, WhatCannotBeReadIsSaidWithTheFile) {
  EXPECT_THAT(errors_of(read_shapes(path("none.geojson"), kOrigin)), HasSubstr("no such file"));
  EXPECT_THAT(errors_of(read_shapes(write("x.shp", ""), kOrigin)), HasSubstr(".geojson"));
  EXPECT_THAT(errors_of(read_shapes(write("bad.geojson", "{\"type\":"), kOrigin)),
              HasSubstr("cannot be read as GeoJSON"));
  EXPECT_THAT(errors_of(read_shapes(write("bad.kml", "<kml><Placemark>"), kOrigin)),
              AllOf(HasSubstr("bad.kml"), HasSubstr("as KML"), Not(HasSubstr(".geojson"))));
  EXPECT_THAT(errors_of(read_shapes(write("bad.wkt", "POLYGON ((0 0, 1"), kOrigin)),
              HasSubstr("line 1 is no WKT"));
  EXPECT_THAT(errors_of(read_shapes(write("point.wkt", "POINT (1 2)"), kOrigin)),
              HasSubstr("no polygon"));
  EXPECT_THAT(errors_of(read_shapes(write("far.wkt", "POLYGON ((0 0, 0 95, 9 9, 0 0))"), kOrigin,
                                    "EPSG:4326")),
              HasSubstr("nowhere on Earth"));
  EXPECT_THAT(errors_of(read_shapes(write("f.geojson", kTwoFields), kOrigin, "EPSG:4326")),
              HasSubstr("says itself"));
}

TEST_F(Shapes, WhatIsWrittenIsReadBackAsItWas) {
  const std::vector<Feature> features = {
      {Feature::Kind::kPolygon, "field", {{0, 0, 50}, {300, 0, 50}, {300, 200, 50}}},
      {Feature::Kind::kLine, "way", {{0, 0, 60}, {300, 200, 80}}},
      {Feature::Kind::kPoint, "start", {{5, 6, 7}}},
      {Feature::Kind::kLine, "nothing", {}}};
  for (const std::string name : {"out.geojson", "out.kml", "out.wkt"}) {
    ASSERT_TRUE(write_features(path(name), features, kOrigin)) << name;
    ASSERT_TRUE(write_features(path(name), features, kOrigin)) << name << " a second time";

    const auto shapes = read_shapes(path(name), kOrigin);

    ASSERT_TRUE(shapes) << errors_of(shapes);
    ASSERT_THAT(*shapes, SizeIs(1)) << name;
    ASSERT_THAT((*shapes)[0].outer, SizeIs(3));
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(((*shapes)[0].outer[i] - features[0].points[i].head<2>()).norm(), 0, 0.02)
          << name;
  }
}

TEST_F(Shapes, HeightsAreWrittenOverTheEllipsoid) {
  ASSERT_TRUE(write_features(
      path("way.geojson"), {{Feature::Kind::kLine, "way", {{0, 0, 60}, {300, 200, 80}}}}, kOrigin));

  std::ifstream in(path("way.geojson"));
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THAT(text, HasSubstr("\"name\": \"way\""));
  EXPECT_THAT(text, HasSubstr("[ -8.0, 40.0, 160.0")) << text;
}

TEST_F(Shapes, WhereNothingCanBeWrittenIsSaid) {
  EXPECT_FALSE(write_features("/nowhere/at/all.geojson", {}, kOrigin));
  EXPECT_FALSE(write_features("/nowhere/at/all.wkt", {}, kOrigin));
  EXPECT_FALSE(write_features(path("way.shp"), {}, kOrigin));
}

}  // namespace
}  // namespace skein::geodata
