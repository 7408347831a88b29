// SPDX-License-Identifier: Apache-2.0
// A run as messages on Earth.
#include "skein/foxglove/export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "skein/mcap/scan.hpp"

namespace skein::foxglove {
namespace {

using journal::Record;
using nlohmann::json;

struct Told {
  std::string topic, schema;
  std::uint64_t time = 0;
  json content;
};

report::RunInfo somewhere() {
  report::RunInfo info;
  info.scenario = "search";
  info.epoch = "2005-05-19T09:00:00Z";
  info.origin = report::Origin{40.0, -8.0, 200.0};
  info.uavs = {{"marvin", "m", 3}, {"heliv", "h", 3}};
  info.zones = {{"Z", {{0, 0}, {100, 0}, {100, 100}}}};
  info.places = {{"pad", {0, 0, 0}}};
  return info;
}

std::vector<Told> exported(const report::RunInfo& info, const std::vector<Record>& records) {
  std::string file;
  mcap::Writer writer({}, [&](std::string_view bytes) { file.append(bytes); });
  export_run(info, records, writer);
  writer.close();
  std::vector<Told> all;
  std::map<mcap::SchemaId, mcap::Schema> schemas = mcap::scan(file, [](auto&, auto&) {}).schemas;
  mcap::scan(file, [&](const mcap::Channel& channel, const mcap::Message& message) {
    all.push_back({channel.topic, schemas.at(channel.schema).name, message.log_time,
                   json::parse(message.data)});
  });
  return all;
}

std::vector<Told> of_topic(const std::vector<Told>& all, const std::string& topic) {
  std::vector<Told> found;
  for (const Told& one : all)
    if (one.topic == topic) found.push_back(one);
  return found;
}

json geojson_of(const Told& told) {
  return json::parse(told.content.at("geojson").get<std::string>());
}

Record line(double at, const std::string& node, const std::string& kind) {
  return {MissionTime::seconds(at), node, kind};
}

Record telemetry(double at, std::vector<double> position, double heading) {
  return line(at, "sim", "telemetry")
      .with("uav", "heliv")
      .with("position", std::move(position))
      .with("velocity", std::vector<double>{1, 2, 3})
      .with("heading", heading)
      .with("energy", 0.5)
      .with("airborne", true);
}

Record planned(double at, int task, std::vector<double> way) {
  return line(at, "heliv", "planned")
      .with("uav", "heliv")
      .with("task", task)
      .with("type", "goto")
      .with("way", std::move(way));
}

// One degree of latitude is 111 km: 111 m north of the origin is a thousandth of one.
TEST(ExportRun, PutsAUavWhereItIsOnEarth) {
  const auto all =
      of_topic(exported(somewhere(), {telemetry(2.5, {0, 111.03, 30}, 0)}), "/heliv/location");

  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].schema, "foxglove.LocationFix");
  const json& fix = all[0].content;
  EXPECT_NEAR(fix.at("latitude").get<double>(), 40.001, 1e-5);
  EXPECT_NEAR(fix.at("longitude").get<double>(), -8.0, 1e-9);
  EXPECT_NEAR(fix.at("altitude").get<double>(), 230, 0.01);
  EXPECT_EQ(fix.at("timestamp").at("sec"), 1116493202);
  EXPECT_EQ(fix.at("timestamp").at("nsec"), 500000000);
  EXPECT_EQ(all[0].time, 1116493202500000000ULL);
}

TEST(ExportRun, TurnsHeadingsToThoseOfACompass) {
  const auto heading = [](double east_ccw) {
    return of_topic(exported(somewhere(), {telemetry(1, {0, 0, 0}, east_ccw)}),
                    "/heliv/location")[0]
        .content.at("heading")
        .get<double>();
  };

  EXPECT_NEAR(heading(0), std::numbers::pi / 2, 1e-12);                            // east
  EXPECT_NEAR(heading(std::numbers::pi / 2), 0, 1e-12);                            // north
  EXPECT_NEAR(std::abs(heading(-std::numbers::pi / 2)), std::numbers::pi, 1e-12);  // south
}

TEST(ExportRun, KeepsEveryRecordAsItIs) {
  const std::vector<Record> records{telemetry(1, {0, 0, 0}, 0),
                                    line(2, "ground", "phase").with("name", "Search")};

  const auto all = exported(somewhere(), records);

  ASSERT_EQ(of_topic(all, "/heliv/telemetry").size(), 1U);
  EXPECT_EQ(of_topic(all, "/heliv/telemetry")[0].content,
            json::parse(journal::to_json(records[0])));
  EXPECT_EQ(of_topic(all, "/ground/phase")[0].schema, "skein.phase");
}

TEST(ExportRun, DrawsZonesOnceClosed) {
  const auto zones = of_topic(exported(somewhere(), {}), "/map/zones");

  ASSERT_EQ(zones.size(), 1U);
  const json features = geojson_of(zones[0]).at("features");
  ASSERT_EQ(features.size(), 2U);
  const json ring = features[0].at("geometry").at("coordinates")[0];
  EXPECT_EQ(ring.size(), 4U);
  EXPECT_EQ(ring.front(), ring.back());
  EXPECT_NEAR(ring[0][1].get<double>(), 40.0, 1e-7);
}

TEST(ExportRun, DrawsClosedAirWhenItClosesAndWhenItOpens) {
  report::RunInfo info = somewhere();
  info.air = {{"tower", {{0, 0}, {10, 0}, {10, 10}}, 0, {}},
              {"fire", {{0, 0}, {10, 0}, {10, 10}}, 5, 8.0},
              {"later", {{0, 0}, {10, 0}, {10, 10}}, 900, {}}};

  const auto air =
      of_topic(exported(info, {line(1, "sim", "x"), line(10, "sim", "x")}), "/map/closed_air");

  ASSERT_EQ(air.size(), 3U);
  EXPECT_EQ(geojson_of(air[0]).at("features").size(), 1U);
  EXPECT_EQ(geojson_of(air[1]).at("features").size(), 2U);
  EXPECT_EQ(geojson_of(air[2]).at("features").size(), 1U);
}

TEST(ExportRun, DrawsPlannedWaysOnceAnInstantAndForgetsThoseThatAreOver) {
  const auto ways = of_topic(
      exported(somewhere(), {planned(1, 1, {0, 0, 0, 9, 9, 9}), planned(1, 2, {0, 0, 0, 5, 5, 5}),
                             line(7, "heliv", "task")
                                 .with("uav", "heliv")
                                 .with("task", 1)
                                 .with("type", "goto")
                                 .with("state", "ended"),
                             line(9, "sim", "x")}),
      "/heliv/way");

  ASSERT_EQ(ways.size(), 2U);
  EXPECT_EQ(geojson_of(ways[0]).at("features").size(), 2U);
  EXPECT_EQ(geojson_of(ways[1]).at("features").size(), 1U);
}

TEST(ExportRun, SaysDecisionsInWords) {
  const auto log = of_topic(
      exported(somewhere(),
               {line(1, "heliv", "decision").with("uav", "heliv").with("operator", "repair")}),
      "/heliv/log");

  ASSERT_EQ(log.size(), 1U);
  EXPECT_EQ(log[0].schema, "foxglove.Log");
  EXPECT_EQ(log[0].content.at("level"), 2);
  EXPECT_EQ(log[0].content.at("name"), "heliv");
}

TEST(ExportRun, WithoutAnOriginHasNoMap) {
  report::RunInfo info = somewhere();
  info.origin.reset();

  for (const Told& one : exported(info, {telemetry(1, {0, 0, 0}, 0)}))
    EXPECT_EQ(one.topic, "/heliv/telemetry");
}

TEST(ExportRun, NamesOfOthersAreTextAndNothingElse) {
  report::RunInfo info = somewhere();
  info.zones[0].name = "\"},{\xff";

  EXPECT_EQ(of_topic(exported(info, {}), "/map/zones").size(), 1U);
}

}  // namespace
}  // namespace skein::foxglove
