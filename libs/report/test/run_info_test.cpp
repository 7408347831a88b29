// SPDX-License-Identifier: Apache-2.0
#include "skein/report/run_info.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "synthetic_mission.hpp"

namespace skein::report {
namespace {

RunInfo full() {
  RunInfo info;
  info.scenario = "comets \"x\" <y>";
  info.epoch = "2005-05-19T09:00:00Z";
  info.runtime = RuntimeKind::kDds;
  info.rate = 20;
  info.seed = 18446744073709551615ULL;
  info.wall_seconds = 75.25;
  info.version = "0.1.0";
  info.origin = Origin{40.5, -8.25, 200};
  info.air = {{"tower", {{0, 0}, {1, 0}, {1, 1}}, 0, {}},
              {"fire", {{0, 0}, {1, 0}, {1, 1}}, 5, 8.5}};
  info.extents = Extents{-1, -2, 3, 4};
  info.terrain = TerrainGrid{-10, -20, 5, 2, 3, {0, 1, 2, 3, 4, 5.25}};
  info.zones = {{"Z", {{0, 0}, {1, 0}, {1, 1}}}};
  info.places = {{"base", {1, 2, 3}}};
  info.uavs = {{"marvin", "heli", 3}, {"karma", "blimp", 4}};
  return info;
}

TEST(RunInfo, GoesThroughJsonUnchanged) {
  const Result<RunInfo, Diagnostics> read = run_info_from_json(to_json(full()), "run.json");

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(*read, full());
}

TEST(RunInfo, OptionalPartsMayBeAbsent) {
  const RunInfo plain;

  const Result<RunInfo, Diagnostics> read = run_info_from_json(to_json(plain), "run.json");

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(*read, plain);
}

TEST(RunInfo, TheSyntheticMissionGoesThroughJson) {
  const RunInfo info = testing::comets_info();

  const Result<RunInfo, Diagnostics> read = run_info_from_json(to_json(info), "run.json");

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->zones, info.zones);
  EXPECT_EQ(read->terrain->values.size(), info.terrain->values.size());
}

TEST(RunInfo, AnOriginThatIsNotOnEarthIsRefused) {
  RunInfo info = full();
  info.origin->latitude = 91;

  const auto read = run_info_from_json(to_json(info), "run.json");

  ASSERT_FALSE(read);
  EXPECT_NE(to_text(read.error()).find("origin: not on Earth"), std::string::npos);
}

TEST(RunInfo, NumbersThatAreNotFiniteAreWrittenAsZero) {
  RunInfo info = full();
  info.rate = std::numeric_limits<double>::infinity();
  info.places[0].position.x = std::numeric_limits<double>::quiet_NaN();

  const Result<RunInfo, Diagnostics> read = run_info_from_json(to_json(info), "run.json");

  ASSERT_TRUE(read);
  EXPECT_EQ(read->rate, 0.0);
  EXPECT_EQ(read->places[0].position.x, 0.0);
}

TEST(RunInfo, UnknownKeysAreNoError) {
  std::string text = to_json(full());
  text.insert(1, "\"weather\": {\"wind\": 3},");

  EXPECT_TRUE(run_info_from_json(text, "run.json"));
}

TEST(RunInfo, AllErrorsAreToldAtOnce) {
  const Result<RunInfo, Diagnostics> read = run_info_from_json(
      R"({"scenario": 1, "runtime": "virtul", "rate": 1, "seed": -1, "wall_seconds": 1,
          "uavs": [{"name": "m", "degree": "x"}, 3], "zones": {}, "places": [{"name": "p"}],
          "terrain": {"west": 0, "south": 0, "cell": 1, "width": 2, "height": 2, "values": [1]}})",
      "run.json");

  ASSERT_FALSE(read);
  EXPECT_EQ(to_text(read.error()),
            "run.json: scenario: not a text; expected a string\n"
            "run.json: runtime: unknown value 'virtul'; expected dds, virtual; did you mean "
            "'virtual'?\n"
            "run.json: seed: not an unsigned integer; expected an unsigned 64-bit integer\n"
            "run.json: terrain: not a grid; expected cell > 0 and width × height values, at most "
            "four million\n"
            "run.json: zones: not a list\n"
            "run.json: places[0].position: missing key\n"
            "run.json: uavs[0].degree: not a number; expected a number\n"
            "run.json: uavs[1]: not an object\n");
}

TEST(RunInfo, WhatIsNotAnObjectIsRefused) {
  EXPECT_FALSE(run_info_from_json("", "run.json"));
  EXPECT_FALSE(run_info_from_json("[]", "run.json"));
  EXPECT_FALSE(run_info_from_json("{\"scenario\"", "run.json"));
}

TEST(RunInfo, APolygonOfAnotherShapeIsRefused) {
  for (const char* polygon : {"3", "[[1]]", "[[1,\"2\"]]", "[{}]", "[[1,1e300]]"}) {
    const std::string text =
        R"({"scenario":"s","runtime":"dds","rate":1,"seed":1,"wall_seconds":1,)"
        R"("zones":[{"name":"Z","polygon":)" +
        std::string(polygon) + "}]}";

    const Result<RunInfo, Diagnostics> read = run_info_from_json(text, "run.json");

    ASSERT_FALSE(read) << polygon;
    EXPECT_EQ(read.error().all()[0].path, "zones[0].polygon");
  }
}

TEST(RunInfo, ATerrainTooLargeForAnyMapIsRefused) {
  const Result<RunInfo, Diagnostics> read = run_info_from_json(
      R"({"scenario":"s","runtime":"dds","rate":1,"seed":1,"wall_seconds":1,"terrain":
          {"west":0,"south":0,"cell":1,"width":4611686018427387904,"height":4,"values":[]}})",
      "run.json");

  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().all()[0].path, "terrain");
}

}  // namespace
}  // namespace skein::report
