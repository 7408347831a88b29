// SPDX-License-Identifier: Apache-2.0
// KML as Google Earth and QGIS write it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/mission_files/read.hpp"

namespace skein::mission_files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string kml(const std::string& features) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
         "xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><Document>\n<name>doc</name>" +
         features + "</Document></kml>\n";
}
std::string placemark(const std::string& name, const std::string& geometry) {
  return "<Placemark><name>" + name + "</name><styleUrl>#a</styleUrl>" + geometry +
         "</Placemark>\n";
}
std::string polygon(const std::string& more = "") {
  return "<Polygon>" + more +
         "<outerBoundaryIs><LinearRing><coordinates>\n 8.1,47.1,0 8.2,47.1,20 8.2,47.2,10 "
         "8.1,47.1,0\n</coordinates></LinearRing></outerBoundaryIs></Polygon>";
}

Contents contents_of(const std::string& text) {
  auto read = read_text(text, "m.kml");
  EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
  return read ? *read : Contents();
}
std::string errors_of(const std::string& text) {
  const auto read = read_text(text, "m.kml");
  EXPECT_FALSE(read);
  return read ? "" : to_text(read.error());
}

TEST(Kml, APolygonIsAnAreaInItsFolders) {
  const Contents contents =
      contents_of(kml("<Folder><name>fences</name>" + placemark("tower", polygon()) + "</Folder>"));

  ASSERT_EQ(contents.areas.size(), 1U);
  EXPECT_EQ(contents.areas[0].name, "tower");
  EXPECT_THAT(contents.areas[0].folders, ElementsAre("doc", "fences"));
  EXPECT_THAT(contents.areas[0].ring,
              ElementsAre(LatLon{47.1, 8.1}, LatLon{47.1, 8.2}, LatLon{47.2, 8.2}));
  EXPECT_FALSE(contents.areas[0].top);
}

TEST(Kml, WhatStandsOnTheGroundHasATop) {
  const Contents contents = contents_of(kml(placemark(
      "a", polygon("<extrude>1</extrude><altitudeMode>relativeToGround</altitudeMode>"))));

  EXPECT_EQ(contents.areas.at(0).top, (Height{20, HeightOver::kGround}));
}

TEST(Kml, LinesAreWaysAndPointsPlaces) {
  const Contents contents = contents_of(
      kml(placemark("lap",
                    "<LineString><altitudeMode>absolute</altitudeMode><coordinates>8,47,500 "
                    "8.1,47.1,510</coordinates></LineString>") +
          placemark("pad", "<Point><coordinates>8.05,47.05</coordinates></Point>")));

  ASSERT_EQ(contents.ways.size(), 1U);
  EXPECT_EQ(contents.ways[0].points[1],
            (Position{{47.1, 8.1}, Height{510, HeightOver::kSeaLevel}}));
  ASSERT_EQ(contents.places.size(), 1U);
  EXPECT_EQ(contents.places[0].name, "pad");
  EXPECT_FALSE(contents.places[0].position.height);
}

TEST(Kml, GeometriesOfOnePlacemarkAreReadOneByOne) {
  const Contents contents = contents_of(
      kml(placemark("both", "<MultiGeometry>" + polygon() + polygon() + "</MultiGeometry>")));

  EXPECT_EQ(contents.areas.size(), 2U);
}

TEST(Kml, APrefixOfItsOwnNamesDoesNotMatter) {
  const Contents contents = contents_of(
      "<k:kml xmlns:k='http://www.opengis.net/kml/2.2'><k:Placemark><k:Point><k:coordinates>8,47"
      "</k:coordinates></k:Point></k:Placemark></k:kml>");

  EXPECT_EQ(contents.places.size(), 1U);
}

TEST(Kml, WhatHasNoCounterpartIsToldWithItsLine) {
  const Contents contents = contents_of(
      kml("\n<NetworkLink><Link><href>http://example.org/x.kml</href></Link></NetworkLink>\n"
          "<GroundOverlay/>\n" +
          placemark("t", "<gx:Track><when>2020</when></gx:Track>") +
          placemark("h",
                    "<Polygon><outerBoundaryIs><LinearRing><coordinates>8,47 9,47 9,48 8,47"
                    "</coordinates></LinearRing></outerBoundaryIs><innerBoundaryIs/></Polygon>") +
          placemark("f", polygon("<altitudeMode>absolute</altitudeMode>"))));

  const std::string told = to_text(contents.left_out);
  EXPECT_THAT(told, HasSubstr("m.kml:4: NetworkLink: <NetworkLink>"));
  EXPECT_THAT(told, HasSubstr("m.kml:5: GroundOverlay: <GroundOverlay>"));
  EXPECT_THAT(told, HasSubstr("gx:Track 't': <gx:Track>"));
  EXPECT_THAT(told, HasSubstr("innerBoundaryIs 'h': a hole"));
  EXPECT_THAT(told, HasSubstr("Polygon 'f': the height of a polygon"));
}

TEST(Kml, EveryErrorIsToldAtOnceWithItsLine) {
  const std::string errors = errors_of(
      kml("\n" + placemark("a", "<Point><coordinates>8;47</coordinates></Point>") +
          placemark("b", "<LineString><coordinates>8,47</coordinates></LineString>") +
          placemark("c", "<Point><coordinates>8,97</coordinates></Point>") +
          placemark("d", "<Polygon/>") +
          placemark("e",
                    "<Point><altitudeMode>high</altitudeMode><coordinates>8,47</coordinates>"
                    "</Point>") +
          placemark("f", "<LineString/>")));

  EXPECT_THAT(errors, HasSubstr("m.kml:4: coordinates 'a': '8;47'; expected longitude,latitude"));
  EXPECT_THAT(errors, HasSubstr("m.kml:5: LineString 'b': 1 coordinates; expected two at least"));
  EXPECT_THAT(errors, HasSubstr("m.kml:6: coordinates 'c': latitude 97"));
  EXPECT_THAT(errors, HasSubstr("m.kml:7: Polygon 'd': no border"));
  EXPECT_THAT(errors, HasSubstr("m.kml:8: Point 'e': altitude mode 'high'"));
  EXPECT_THAT(errors, HasSubstr("m.kml:9: LineString 'f': no <coordinates>"));
}

TEST(Kml, ADocumentTypeIsRefused) {
  EXPECT_THAT(errors_of("<!DOCTYPE kml [<!ENTITY a 'b'>]><kml>&a;</kml>"),
              HasSubstr("a document type declaration"));
}

TEST(Kml, FoldersInFoldersAreFollowedSixtyFourDeep) {
  std::string open, close;
  for (int i = 0; i < 59; ++i) open += "<Folder>", close += "</Folder>";
  const std::string point = placemark("p", "<Point><coordinates>8,47</coordinates></Point>");

  EXPECT_EQ(contents_of(kml(open + point + close)).places.size(), 1U);
  EXPECT_THAT(errors_of(kml(open + "<Folder>" + point + "</Folder>" + close)),
              HasSubstr("nested more than 64 deep"));
}

}  // namespace
}  // namespace skein::mission_files
