// SPDX-License-Identifier: Apache-2.0
// Plans of QGroundControl, in the form in which it saves them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/mission_files/read.hpp"

namespace skein::mission_files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A plan with these items, and more keys after the mission.
std::string plan(const std::string& items, const std::string& more = "") {
  return R"({
    "fileType": "Plan",
    "groundStation": "QGroundControl",
    "mission": {
        "cruiseSpeed": 15,
        "firmwareType": 12,
        "globalPlanAltitudeMode": 1,
        "hoverSpeed": 5,
        "items": [)" +
         items + R"(],
        "plannedHomePosition": [47.5, 8.25, 430.5],
        "vehicleType": 2,
        "version": 2
    })" + more +
         R"(,
    "version": 1
}
)";
}

std::string item(int command, int frame, const std::string& params) {
  return R"({"AMSLAltAboveTerrain": null, "Altitude": 30, "AltitudeMode": 1, "autoContinue": true, "command": )" +
         std::to_string(command) + R"(, "doJumpId": 1, "frame": )" + std::to_string(frame) +
         R"(, "params": [)" + params + R"(], "type": "SimpleItem"})";
}

Contents contents_of(const std::string& text) {
  auto read = read_text(text, "test.plan");
  EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
  return read ? *read : Contents();
}
std::string errors_of(const std::string& text) {
  const auto read = read_text(text, "test.plan");
  EXPECT_FALSE(read);
  return read ? "" : to_text(read.error());
}

TEST(Plan, AMissionIsReadStepByStep) {
  const Contents contents = contents_of(plan(item(22, 3, "15, 0, 0, null, 47.5, 8.25, 30") + ",\n" +
                                             item(178, 2, "1, 7.5, -1, 0, 0, 0, 0") + ",\n" +
                                             item(16, 3, "4, 0, 0, null, 47.501, 8.251, 35") +
                                             ",\n" + item(93, 2, "12, -1, -1, -1, 0, 0, 0") +
                                             ",\n" + item(20, 2, "0, 0, 0, 0, 0, 0, 0")));

  ASSERT_EQ(contents.items.size(), 5U);
  EXPECT_EQ(std::get<TakeOff>(contents.items[0].step).to, (Height{30, HeightOver::kHome}));
  EXPECT_EQ(std::get<ChangeSpeed>(contents.items[1].step).speed, 7.5);
  const auto& fly = std::get<FlyTo>(contents.items[2].step);
  EXPECT_EQ(fly.to, (Position{{47.501, 8.251}, Height{35, HeightOver::kHome}}));
  EXPECT_EQ(fly.hold, 4);
  EXPECT_EQ(std::get<Delay>(contents.items[3].step).seconds, 12);
  EXPECT_TRUE(std::holds_alternative<ReturnHome>(contents.items[4].step));
  ASSERT_TRUE(contents.home);
  EXPECT_EQ(contents.home->at, (LatLon{47.5, 8.25}));
  EXPECT_EQ(contents.home->over_sea, 430.5);
}

TEST(Plan, WhatATakeoffAsksBesidesItsHeightIsTold) {
  const Contents contents = contents_of(plan(item(22, 3, "15, 0, 0, 90, 47.5, 8.25, 30")));

  EXPECT_EQ(to_text(contents.left_out),
            "test.plan:9: mission.items[0]: NAV_TAKEOFF (22): a heading (parameter 4)\n");
}

TEST(Plan, HeightsCountFromWhatTheirFrameSays) {
  const Contents contents = contents_of(plan(item(16, 0, "0,0,0,0, 47.5, 8.25, 480") + "," +
                                             item(16, 3, "0,0,0,0, 47.5, 8.25, 30") + "," +
                                             item(16, 10, "0,0,0,0, 47.5, 8.25, 40")));

  std::vector<Height> heights;
  for (const Item& one : contents.items) heights.push_back(*std::get<FlyTo>(one.step).to.height);
  EXPECT_THAT(heights, ElementsAre(Height{480, HeightOver::kSeaLevel},
                                   Height{30, HeightOver::kHome}, Height{40, HeightOver::kGround}));
}

TEST(Plan, ASurveyIsItsItemsAndItsArea) {
  const Contents contents = contents_of(plan(
      R"({"TransectStyleComplexItem": {"CameraCalc": {"DistanceToSurface": 50}, "Items": [)" +
      item(16, 3, "0,0,0,null, 47.501, 8.251, 50") + "," + item(206, 2, "25, 0, 1, 0, 0, 0, 0") +
      "," + item(16, 3, "0,0,0,null, 47.502, 8.251, 50") + "," +
      item(206, 2, "0, 0, 1, 0, 0, 0, 0") +
      R"(], "version": 1}, "angle": 0, "complexItemType": "survey",
      "polygon": [[47.501, 8.251], [47.501, 8.252], [47.502, 8.252]], "type": "ComplexItem", "version": 5})"));

  ASSERT_EQ(contents.items.size(), 4U);
  EXPECT_EQ(std::get<TakePictures>(contents.items[1].step).count, 0);
  EXPECT_TRUE(std::holds_alternative<StopPictures>(contents.items[3].step));
  ASSERT_EQ(contents.areas.size(), 1U);
  EXPECT_EQ(contents.areas[0].name, "survey");
  EXPECT_THAT(contents.areas[0].ring,
              ElementsAre(LatLon{47.501, 8.251}, LatLon{47.501, 8.252}, LatLon{47.502, 8.252}));
}

TEST(Plan, FencesAndRallyPointsAreRead) {
  const Contents contents = contents_of(plan("", R"(, "geoFence": {"circles": [
      {"circle": {"center": [47.6, 8.3], "radius": 120.5}, "inclusion": false, "version": 1}],
    "polygons": [{"inclusion": true, "polygon": [[47, 8], [47, 9], [48, 9], [48, 8]], "version": 1}],
    "version": 2}, "rallyPoints": {"points": [[47.5, 8.26, 20]], "version": 2})"));

  ASSERT_EQ(contents.fences.size(), 2U);
  EXPECT_TRUE(contents.fences[0].inclusion);
  EXPECT_EQ(std::get<std::vector<LatLon>>(contents.fences[0].shape).size(), 4U);
  EXPECT_FALSE(contents.fences[1].inclusion);
  EXPECT_EQ(std::get<Circle>(contents.fences[1].shape).radius, 120.5);
  ASSERT_EQ(contents.places.size(), 1U);
  EXPECT_EQ(contents.places[0].position.height, (Height{20, HeightOver::kHome}));
}

TEST(Plan, WhatHasNoCounterpartIsToldByItsNameAndPlace) {
  const Contents contents = contents_of(
      plan(item(177, 2, "1, 3, 0, 0, 0, 0, 0") + "," + item(195, 3, "0,0,0,0,47.5,8.2,0") + "," +
               item(9999, 2, "0,0,0,0,0,0,0") + "," +
               R"({"complexItemType": "StructureScan", "type": "ComplexItem", "polygon": []})",
           R"(, "geoFence": {"breachReturn": [47, 8, 30], "version": 2}, "extra": 1)"));

  const std::string told = to_text(contents.left_out);
  EXPECT_THAT(told, HasSubstr("mission.items[0]: DO_JUMP (177)"));
  EXPECT_THAT(told, HasSubstr("mission.items[1]: DO_SET_ROI_LOCATION (195)"));
  EXPECT_THAT(told, HasSubstr("mission.items[2]: command 9999"));
  EXPECT_THAT(told, HasSubstr("mission.items[3]: a complex item 'StructureScan'"));
  EXPECT_THAT(told, HasSubstr("geoFence.breachReturn: 'breachReturn'"));
  EXPECT_THAT(told, HasSubstr("extra: 'extra'"));
  EXPECT_TRUE(contents.items.empty());
}

TEST(Plan, EveryErrorIsToldAtOnceWithItsLineAndPath) {
  const std::string errors = errors_of(
      plan(item(16, 3, "0,0,0,0, 97.5, 8.25, 30") + ",\n" + item(16, 1, "0,0,0,0, 47.5, 8.25, 30") +
               ",\n" + item(16, 3, "0,0,0,0, 0, 0, 30") + ",\n" + item(16, 3, "1, 2, 3") + ",\n" +
               item(16, 3, "-4,0,0,0, 47.5, 8.25, 30") + ",\n" +
               item(16, 3, "0,0,0,0, 47.5, 8.25, null"),
           R"(, "geoFence": {"polygons": [{"inclusion": true, "polygon": [[1, 2]]}]})"));

  EXPECT_THAT(errors, HasSubstr("test.plan:9: mission.items[0]: latitude 97.5"));
  EXPECT_THAT(errors, HasSubstr("test.plan:10: mission.items[1]: NAV_WAYPOINT (16): frame 1"));
  EXPECT_THAT(errors, HasSubstr("test.plan:11: mission.items[2]: NAV_WAYPOINT (16): no place"));
  EXPECT_THAT(errors, HasSubstr("mission.items[3].params: 3 parameters; expected 7"));
  EXPECT_THAT(errors, HasSubstr("mission.items[4]: NAV_WAYPOINT (16): a hold of -4"));
  EXPECT_THAT(errors, HasSubstr("mission.items[5]: NAV_WAYPOINT (16): no height"));
  EXPECT_THAT(errors, HasSubstr("geoFence.polygons[0].polygon: no polygon"));
}

TEST(Plan, OtherVersionsAndOtherFilesAreRefused) {
  EXPECT_THAT(errors_of(R"({"fileType": "Parameters", "version": 1})"),
              HasSubstr("fileType: 'Parameters'; expected Plan"));
  EXPECT_THAT(errors_of(R"({"fileType": "Plan", "version": 2, "mission": {"items": []}})"),
              HasSubstr("version: version 2; expected version 1"));
  EXPECT_THAT(errors_of("[1, 2]"), HasSubstr("no plan"));
  EXPECT_THAT(errors_of("{\"fileType\": \"Plan\", "), HasSubstr("test.plan:"));
}

TEST(Plan, HomeOfAGeneratorThatKnowsNoneIsNone) {
  std::string text = plan(item(22, 3, "0,0,0,0,0,0,10"));
  const std::string home = "[47.5, 8.25, 430.5]";
  text.replace(text.find(home), home.size(), "[0.0, 0.0, 0.0]");

  EXPECT_FALSE(contents_of(text).home);
}

TEST(Plan, TabsAndEscapesOfJsonAreRead) {
  const Contents contents = contents_of(
      "{\n\t\"fileType\": \"Plan\",\n\t\"version\":1,\n\t\"groundStation\":\"a\\/b \\u00e9\",\n"
      "\t\"mission\":{\"version\":2,\"items\":[\n\t\t" +
      item(21, 3, "0,0,0,0,0,0,0") + "\n\t]}\n}\n");

  ASSERT_EQ(contents.items.size(), 1U);
  EXPECT_FALSE(std::get<Land>(contents.items[0].step).at);
}

}  // namespace
}  // namespace skein::mission_files
